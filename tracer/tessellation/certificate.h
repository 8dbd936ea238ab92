// A proof, for many cells of a grid at once, that their triangles lie near a patch.
#pragma once

#include <array>

#include "tracer/splines/bicubic.h"

namespace lancer::splines {

/// Bounds on a patch's second derivatives, across the surface and along it, over a rectangle of its
/// parameters with a margin. From these cell_distance() bounds the distance of the triangles over
/// the rectangle from the surface.
///
/// Let S be the surface and L a triangle with corners on it. At equal parameters S - L is a mean of
/// second derivatives (Filip, Magedson, Markot, CAGD 3, 1986). But most of this difference may lie
/// along the surface, and does not count as distance. So L is compared with a shifted point of S.
/// Let N be the normal at the rectangle's centre, and a, b the rows dual to the slopes there. If
/// the slopes stay near those at the centre, a shift (r, s) of the parameters with a.(S(u - r, v -
/// s) - L) = b.(...) = 0 exists by Brouwer's fixed point theorem. The remaining difference lies
/// along N.
class Certificate {
  public:
    /// \param curvature  of p
    /// \param margin_u, margin_v  the largest shift; at most the size of a cell is sensible
    Certificate(const Bicubic<double>& p, const Curvature& curvature, double u0, double u1,
                double v0, double v1, double margin_u, double margin_v);

    /// An upper bound on the distance from the patch of both triangles of a cell du x dv. The cell
    /// is halved by the diagonal along (du, dv) if `rising`, else along (du, -dv); the corners lie
    /// on the surface. Infinite if the rectangle is too curved, or at a pole.
    double cell_distance(double du, double dv, bool rising) const;

  private:
    /// A range of numbers, [mid - radius, mid + radius].
    struct Range {
        double mid = 0;
        double radius = 0;
        double largest() const { return std::abs(mid) + radius; }
    };
    /// Ranges of the second derivatives of one coordinate, over the rectangle with its margin.
    struct Second {
        Range uu, uv, vv;
    };
    /// Bounds on the absolute values of a shift.
    struct Shift {
        double u, v;
    };

    Second along(const Vec3d& direction) const;
    static double chord(const Second& second, const std::array<Vec2d, 3>& at);
    /// Bounds the shift, from bounds on S - L along a and b. False if there may be none.
    bool find_shift(double along_a, double along_b, Shift& shift) const;
    double tilt(const Shift& shift) const;

    Curvature curvature_;  ///< over the rectangle with its margin
    double margin_u_, margin_v_;
    double reach_u_, reach_v_;                     ///< from the centre to the end of the margin
    bool regular_ = false;                         ///< the slopes at the centre span a plane
    Vec3d n_{0}, rows_[2] = {Vec3d(0), Vec3d(0)};  ///< N; a and b
    Second normal_, a_, b_;
};

}  // namespace lancer::splines
