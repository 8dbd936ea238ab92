// The three number types. Each is compiled in its own file.
#pragma once

#include <memory>

#include "tracer/ray_tree_renderer.h"

namespace lancer {

std::unique_ptr<RayTreeRenderer> compile_single(const Scene& scene, const Settings& settings);
std::unique_ptr<RayTreeRenderer> compile_double(const Scene& scene, const Settings& settings,
                                                Level level);
std::unique_ptr<RayTreeRenderer> compile_extended(const Scene& scene, const Settings& settings);

}  // namespace lancer
