// A renderer that also tells what one ray does: for people who ask why a pixel has its colour.
#pragma once

#include <memory>

#include "tracer/rays/ray_tree.h"
#include "tracer/render.h"

namespace lancer {

class RayTreeRenderer : public Renderer {
  public:
    /// All that the ray through the point does, written down by the recursion that makes the
    /// picture: its color has the bits that trace() gives.
    virtual RayTree ray_tree(const View& view, const PicturePoint& at) const = 0;
};

/// compile() with one ray at a time. Throws SceneError as it does.
std::unique_ptr<RayTreeRenderer> compile_for_ray_trees(const Scene& scene,
                                                       const Settings& settings);

}  // namespace lancer
