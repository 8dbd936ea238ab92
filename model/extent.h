// Bounding boxes, and whether convex bodies contain a point: rough answers before anything is
// traced.
#pragma once

#include <limits>

#include "model/shapes.h"

namespace lancer {

/// An axis-aligned box; unbounded where nothing is known.
struct Extent {
    Vec3d min{-std::numeric_limits<double>::infinity()};
    Vec3d max{std::numeric_limits<double>::infinity()};

    bool is_finite() const;
    /// Whether the box is empty in some direction by more than rounding errors.
    bool is_inside_out() const;
};

Extent around(const Vec3d& center, const Vec3d& half);
/// The box around both.
Extent joined(const Extent& a, const Extent& b);
/// The intersection; inside out when the boxes are apart.
Extent common(const Extent& a, const Extent& b);

/// The box of a sphere, box, cylinder, cone or torus, except for rounding; unbounded for other
/// shapes.
Extent shape_extent(const Shape& shape);

/// Whether a sphere, box, cylinder, cone or half space contains the point; false for others.
bool convex_holds(const Shape& shape, const Vec3d& p);

}  // namespace lancer
