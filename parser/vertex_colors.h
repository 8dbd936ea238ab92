// Checks materials that take vertex colours against shapes that have none.
#pragma once

#include "model/scene.h"
#include "parser/report.h"

namespace lancer {

/// Reports every shape whose material says `color vertex` and that is not a mesh with vertex
/// colours. The material of a shape is known only when its groups are closed.
void check_vertex_colors(const Scene& scene, Report& report);

}  // namespace lancer
