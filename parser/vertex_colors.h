// Materials that take the colours of vertices, and shapes that have none.
#pragma once

#include "model/scene.h"
#include "parser/report.h"

namespace lancer {

/// Reports every shape whose material says `color vertex` and that is no mesh with colours: what a
/// shape wears is known only when its groups are closed.
void check_vertex_colors(const Scene& scene, Report& report);

}  // namespace lancer
