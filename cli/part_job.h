// One part of a picture: which strips of it this run draws.
#pragma once

#include <string>

#include "accuracy/picture_samples.h"
#include "cli/arguments.h"
#include "model/io/part_layout.h"
#include "tracer/render.h"

namespace lancer::cli {

/// What the part says of itself. `by_error`: its samples are those that an error asks for. Throws
/// UsageError when the picture has fewer rows than parts.
io::PartHead head_of(const PartOf& part, const View& view, const io::Origin& origin, bool by_error);

/// Draws the part and writes it. Throws FileError, SceneError.
void draw_part(const Renderer& renderer, const View& view, const io::PartHead& head,
               const std::string& output, const Progress& progress, RayCounts& rays);

/// The part's rows.
accuracy::PictureRows rows_of(const io::PartHead& head);

/// Writes the part that is drawn already: its rows one below the other. Throws FileError.
void write_drawn(const Image& rows, const io::PartHead& head, const std::string& output);

}  // namespace lancer::cli
