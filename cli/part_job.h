// One part of a picture: the strips that this run draws.
#pragma once

#include <string>

#include "accuracy/picture_samples.h"
#include "cli/arguments.h"
#include "model/io/part_layout.h"
#include "tracer/render.h"

namespace lancer::cli {

/// The header of the part's file. `by_error`: its samples depend on a target error. Throws
/// UsageError when the picture has fewer rows than parts.
io::PartHead head_of(const PartOf& part, const View& view, const io::Origin& origin, bool by_error);

/// Draws the part and writes it. Throws FileError, SceneError.
void draw_part(const Renderer& renderer, const View& view, const io::PartHead& head,
               const std::string& output, const Progress& progress, RayCounts& rays);

/// The rows of the part.
accuracy::PictureRows rows_of(const io::PartHead& head);

/// Writes a part that is already drawn; its rows are stacked without gaps. Throws FileError.
void write_drawn(const Image& rows, const io::PartHead& head, const std::string& output);

}  // namespace lancer::cli
