// A proof for many cells of a grid at once that their triangles lie near a patch.
#pragma once

#include <array>

#include "tracer/splines/bicubic.h"

namespace lancer::splines {

/// What holds all over a rectangle of a patch's parameters and a margin around it: bounds on the
/// second derivatives, across the surface and along it. From these cell_distance() bounds how far
/// the triangles over the rectangle are from the surface.
///
/// A chord triangle differs from the surface over it, S - L at equal parameters, by the mean of
/// second derivatives (Filip, Magedson, Markot, CAGD 3, 1986), but most of this may be a slide
/// along the surface, which is no distance. So the point compared with is shifted: with N the
/// normal at the rectangle's centre and a, b the rows dual to the slopes there, a shift (r, s) of
/// the parameters with a.(S(u - r, v - s) - L) = b.(...) = 0 exists by Brouwer's fixed point
/// theorem when the slopes stay near those of the centre. What is left lies along N.
class Certificate {
  public:
    /// \param curvature  of p
    /// \param margin_u, margin_v  the largest shift looked for; at most a cell is sensible
    Certificate(const Bicubic<double>& p, const Curvature& curvature, double u0, double u1,
                double v0, double v1, double margin_u, double margin_v);

    /// Upper bound of the distance from the patch of both triangles, with corners on the surface,
    /// of a cell du x dv, the margin away from the patch's border, halved by the diagonal along
    /// (du, dv) or (du, -dv); infinite where the rectangle is too curved, or at a pole.
    double cell_distance(double du, double dv, bool rising) const;

  private:
    /// A number somewhere in [mid - radius, mid + radius].
    struct Range {
        double mid = 0;
        double radius = 0;
        double largest() const { return std::abs(mid) + radius; }
    };
    /// Second derivatives of a coordinate, over the rectangle with its margin.
    struct Second {
        Range uu, uv, vv;
    };
    /// Bounds on its size.
    struct Shift {
        double u, v;
    };

    Second along(const Vec3d& direction) const;
    static double chord(const Second& second, const std::array<Vec2d, 3>& at);
    /// From bounds on S - L along a and b.
    bool find_shift(double along_a, double along_b, Shift& shift) const;
    double tilt(const Shift& shift) const;

    Curvature curvature_;  ///< over the rectangle with its margin
    double margin_u_, margin_v_;
    double reach_u_, reach_v_;                     ///< from the centre to the margin's end
    bool regular_ = false;                         ///< the slopes at the centre span a plane
    Vec3d n_{0}, rows_[2] = {Vec3d(0), Vec3d(0)};  ///< N; a and b
    Second normal_, a_, b_;
};

}  // namespace lancer::splines
