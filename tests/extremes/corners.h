// Bodies cut from bodies, of glass, seen where three faces of different parts meet.
#pragma once

#include <random>

#include "model/scene.h"
#include "tests/extremes/stage.h"

namespace lancer::extremes {

/// A glass body, as it is or turned and stretched, and a camera that looks at a point of it
/// closely.
class CloseView {
  public:
    CloseView(std::mt19937& random, int side);

    double unit() { return static_cast<double>(random_()) / 4294967296.0; }
    /// Seen from one place towards another, both in the body's own space, zoomed up to 10^12.
    Scene of(const Vec3d& from, const Vec3d& at, const Vec3d& aside);

  private:
    std::mt19937& random_;

  public:
    const Affine<double> map;  ///< into the world
    Stage stage;
};

/// One of several bodies, as it is or turned and stretched, seen from anywhere, zoomed up to 10^12
/// onto a corner, or onto an edge next to it. A picture of odd size aims its middle ray at the very
/// place.
Scene random_corner(std::mt19937& random, int side);

}  // namespace lancer::extremes
