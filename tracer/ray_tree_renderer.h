// A renderer that also returns ray trees, which show why a pixel has its colour.
#pragma once

#include <memory>

#include "tracer/rays/ray_tree.h"
#include "tracer/render.h"

namespace lancer {

class RayTreeRenderer : public Renderer {
  public:
    /// The ray tree of the ray through the point, recorded by the recursion that makes the picture.
    /// Its color has the same bits as that of trace().
    virtual RayTree ray_tree(const View& view, const PicturePoint& at) const = 0;
};

/// compile() for one ray at a time. Throws SceneError as compile() does.
std::unique_ptr<RayTreeRenderer> compile_for_ray_trees(const Scene& scene,
                                                       const Settings& settings);

}  // namespace lancer
