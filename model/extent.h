// Boxes round bodies, and whether convex bodies hold a point: rough answers, before anything is
// traced.
#pragma once

#include <limits>

#include "model/shapes.h"

namespace lancer {

/// A box along the axes; without limits where nothing is known.
struct Extent {
    Vec3d min{-std::numeric_limits<double>::infinity()};
    Vec3d max{std::numeric_limits<double>::infinity()};

    bool is_finite() const;
    /// Whether it is less than nothing in a direction, by more than rounding made of its ends.
    bool is_inside_out() const;
};

Extent around(const Vec3d& center, const Vec3d& half);
/// Round both.
Extent joined(const Extent& a, const Extent& b);
/// What both hold; inside out where they lie apart.
Extent common(const Extent& a, const Extent& b);

/// Of a ball, box, cylinder, cone or torus, but for rounding; of others the box without limits.
Extent shape_extent(const Shape& shape);

/// Whether a ball, box, cylinder, cone or half space holds the point; false for others.
bool convex_holds(const Shape& shape, const Vec3d& p);

}  // namespace lancer
