// A proof that a triangle lies near a patch, by the feet of its points.
#pragma once

#include <array>

#include "tracer/splines/bicubic.h"

namespace lancer::splines {

/// A point with a place of the patch near it, its foot.
struct FootPoint {
    Vec2d at;     ///< the foot's parameters
    Vec3d point;  ///< the point itself
    Vec3d off;    ///< the foot less the point

    /// A point of the patch is its own foot.
    static FootPoint on(const Bicubic<double>& p, const Vec2d& at);
};

/// A patch and how near to it triangles must be.
class NearPatch {
  public:
    NearPatch(const Bicubic<double>& points, double tolerance)
        : points_(points), curvature_(points), tolerance_(tolerance) {}

    const Bicubic<double>& points() const { return points_; }
    const Curvature& curvature() const { return curvature_; }
    double tolerance() const { return tolerance_; }

    /// Whether every point of the triangle is proved to be within the tolerance of the patch, as a
    /// whole or in parts, by halving its sides again and again:
    ///
    /// - A point with weights x, y, z is compared with the patch at this mean of the corners'
    ///   feet. They differ by no more than the largest `off` and what the patch bends over the
    ///   feet, see chord_error(); with every halving the bend falls to a quarter, and the new
    ///   corners get feet of their own. So what is proved comes down to distances measured at
    ///   points.
    /// - Where feet leap, from one side of a fold to the other, a part lies in a ball about a foot.
    ///
    /// What fails at one of the points fails at once.
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
