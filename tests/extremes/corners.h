// Glass composites, seen where three faces of different parts meet.
#pragma once

#include <random>

#include "model/scene.h"
#include "tests/extremes/stage.h"

namespace lancer::extremes {

/// A glass body, possibly rotated and stretched, and a camera close to one of its points.
class CloseView {
  public:
    CloseView(std::mt19937& random, int side);

    double unit() { return static_cast<double>(random_()) / 4294967296.0; }
    /// The view from one place towards another, both in the body's own space, zoomed up to 10^12.
    Scene of(const Vec3d& from, const Vec3d& at, const Vec3d& aside);

  private:
    std::mt19937& random_;

  public:
    const Affine<double> map;  ///< into the world
    Stage stage;
};

/// One of several bodies, possibly rotated and stretched, seen from anywhere and zoomed up to 10^12
/// onto a corner or a nearby edge. The middle ray of a picture with an odd size hits this place
/// exactly.
Scene random_corner(std::mt19937& random, int side);

}  // namespace lancer::extremes
