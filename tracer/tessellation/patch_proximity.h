// A proof that a triangle lies near a patch, by the foot points of its points.
#pragma once

#include <array>

#include "tracer/splines/bicubic.h"

namespace lancer::splines {

/// A point with its foot, a point of the patch near it.
struct FootPoint {
    Vec2d at;     ///< the foot's parameters
    Vec3d point;  ///< the point itself
    Vec3d off;    ///< the foot minus the point

    /// A point of the patch is its own foot.
    static FootPoint on(const Bicubic<double>& p, const Vec2d& at);
};

/// A patch, and the tolerance within which triangles must lie near it.
class NearPatch {
  public:
    NearPatch(const Bicubic<double>& points, double tolerance)
        : points_(points), curvature_(points), tolerance_(tolerance) {}

    const Bicubic<double>& points() const { return points_; }
    const Curvature& curvature() const { return curvature_; }
    double tolerance() const { return tolerance_; }

    /// Whether every point of the triangle is proved to be within the tolerance of the patch. The
    /// triangle is proved as a whole or in parts, by halving its sides repeatedly:
    ///
    /// - The point with barycentric coordinates x, y, z is compared with the patch at the same mean
    ///   of the corners' feet. The difference is at most the largest `off` plus the chord error of
    ///   the patch over the feet, see chord_error(). Each halving reduces the chord error to a
    ///   quarter, and the new corners get their own feet. So finally only distances at points
    ///   count.
    /// - The feet of neighbouring points may lie on different sides of a fold. There a part of the
    ///   triangle must lie in a ball about a foot.
    ///
    /// If one of these points is too far away, the result is false at once.
    bool holds(const std::array<FootPoint, 3>& triangle) const;

  private:
    /// Bounds on the second derivatives over a rectangle of the parameters.
    struct Bends {
        Vec2d low;
        Vec2d high;
        SecondDerivatives most;
    };

    bool holds(const std::array<FootPoint, 3>& t, const Bends& around, int halvings,
               int& parts) const;
    Bends bends_over(const Vec2d& low, const Vec2d& high) const;
    FootPoint with_foot(const Vec3d& point, const Vec2d& from, const Vec2d& free) const;
    FootPoint middle(const FootPoint& a, const FootPoint& b) const;

    Bicubic<double> points_;
    Curvature curvature_;
    double tolerance_;
};

}  // namespace lancer::splines
