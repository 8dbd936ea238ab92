// One part of a picture: which strips of it this run draws.
#pragma once

#include <string>

#include "cli/arguments.h"
#include "model/io/part_layout.h"
#include "tracer/render.h"

namespace lancer::cli {

/// What the part says of itself. Throws UsageError when the picture has fewer rows than parts.
io::PartHead head_of(const PartOf& part, const View& view, const io::Origin& origin);

/// Draws the part and writes it. Throws FileError, SceneError.
void draw_part(const Renderer& renderer, const View& view, const io::PartHead& head,
               const std::string& output, const Progress& progress, RayCounts& rays);

}  // namespace lancer::cli
