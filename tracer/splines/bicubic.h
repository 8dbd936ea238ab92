// A bicubic Bezier patch: point, derivatives, normal, and bounds on its second derivatives.
// Farin, Curves and Surfaces for CAGD, 5th ed., chapters 14 and 16.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "model/math.h"
#include "tracer/splines/bernstein.h"

namespace lancer::splines {

/// 16 control points, row by row: u along a row, v from row to row.
template <class Real>
using Bicubic = std::array<Vec3<Real>, 16>;

template <class Real>
struct PatchSample {
    Vec3<Real> point;
    Vec3<Real> du;
    Vec3<Real> dv;
};

/// A parameter in [0, 1] as two weights with the sum 1. The mirrored parameter has the same weights
/// swapped, bit for bit. So a curve has the same points in both directions.
template <class Real>
struct Place {
    Real s;
    Real rest;  ///< 1 - s

    explicit Place(Real s_) : s(s_), rest(1 - s_) {}
    /// index / count
    Place(int index, int count)
        : s(static_cast<Real>(index) / static_cast<Real>(count)),
          rest(static_cast<Real>(count - index) / static_cast<Real>(count)) {}
};

/// Point and derivative of a cubic. If both the points and the parameter are reversed, the point is
/// the same.
template <class Real>
std::pair<Vec3<Real>, Vec3<Real>> cubic(const Vec3<Real>& p0, const Vec3<Real>& p1,
                                        const Vec3<Real>& p2, const Vec3<Real>& p3,
                                        const Place<Real>& at) {
    const auto mix = [&](const Vec3<Real>& a, const Vec3<Real>& b) {
        return a * at.rest + b * at.s;
    };
    const Vec3<Real> a = mix(p0, p1);
    const Vec3<Real> b = mix(p1, p2);
    const Vec3<Real> c = mix(p2, p3);
    const Vec3<Real> ab = mix(a, b);
    const Vec3<Real> bc = mix(b, c);
    return {mix(ab, bc), Real(3) * (bc - ab)};
}

template <class Real>
PatchSample<Real> sample(const Bicubic<Real>& p, const Place<Real>& u, const Place<Real>& v) {
    std::array<Vec3<Real>, 4> point;
    std::array<Vec3<Real>, 4> slope;
    for (std::size_t i = 0; i < 4; ++i) {
        std::tie(point[i], slope[i]) = cubic(p[4 * i], p[4 * i + 1], p[4 * i + 2], p[4 * i + 3], u);
    }
    PatchSample<Real> at;
    std::tie(at.point, at.dv) = cubic(point[0], point[1], point[2], point[3], v);
    at.du = cubic(slope[0], slope[1], slope[2], slope[3], v).first;
    return at;
}

/// The largest distance of neighbouring control points, as a scale for derivatives.
template <class Real>
Real net_step(const Bicubic<Real>& p) {
    Real largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            largest = std::max(largest, length_squared(p[4 * i + j + 1] - p[4 * i + j]));
            largest = std::max(largest, length_squared(p[4 * (j + 1) + i] - p[4 * j + i]));
        }
    }
    using std::sqrt;
    return sqrt(largest);
}

/// The unit normal of du x dv. Where the two derivatives do not span a plane (a pole, coincident
/// control points, a border that folds), it is the limit from inside the patch. 0 if the whole
/// patch has no normal.
template <class Real>
Vec3<Real> normal(const Bicubic<Real>& p, const Real u, const Real v) {
    using std::sqrt;
    const Real step = net_step(p);
    // Below this the cross product is mostly rounding.
    const Real rounding = sqrt(std::numeric_limits<Real>::epsilon());
    const auto at = [&](Real s, Real t, Real least) {
        const PatchSample<Real> q = sample(p, Place<Real>(s), Place<Real>(t));
        const Vec3<Real> n = cross(q.du, q.dv);
        const Real size = sqrt(length_squared(n));
        return size > least * step * step ? n / size : Vec3<Real>(0);
    };
    Vec3<Real> n = at(u, v, rounding / 64);
    for (Real move = rounding; n == Vec3<Real>(0) && move < Real(0.5); move *= 16) {
        const Real inner_u = u + move * (u < Real(0.5) ? 1 : -1);
        const Real inner_v = v + move * (v < Real(0.5) ? 1 : -1);
        // First only across the border: at a pole, the parameter along the border is then kept.
        const PatchSample<Real> q = sample(p, Place<Real>(u), Place<Real>(v));
        const Real du = length_squared(q.du);
        const Real dv = length_squared(q.dv);
        if (du <= dv) n = at(u, inner_v, rounding * move);
        if (n == Vec3<Real>(0) && dv <= du) n = at(inner_u, v, rounding * move);
        if (n == Vec3<Real>(0)) n = at(inner_u, inner_v, rounding * move);
    }
    return n;
}

/// Bounds on |Suu|, |Suv|, |Svv| over a part of the parameter square.
struct SecondDerivatives {
    double uu = 0;
    double uv = 0;
    double vv = 0;
};

/// The Rows x Columns control vectors of a tensor-product polynomial.
template <std::size_t Rows, std::size_t Columns>
struct VectorNet {
    std::array<std::array<Vec3d, Columns>, Rows> c;
};

/// Changes Bernstein coefficients over [0, 1] to those over [low, high], by de Casteljau twice.
template <std::size_t Count>
void restrict_to(std::array<Vec3d, Count>& c, double low, double high) {
    for (std::size_t n = Count - 1; n > 0; --n) {  // keep [0, high]
        for (std::size_t i = Count - 1; i >= Count - n; --i)
            c[i] = c[i - 1] * (1 - high) + c[i] * high;
    }
    const double from = high > 0 ? low / high : 1;
    for (std::size_t n = Count - 1; n > 0; --n) {  // keep [from, 1]
        for (std::size_t i = 0; i < n; ++i) c[i] = c[i] * (1 - from) + c[i + 1] * from;
    }
}

/// The control vectors over a rectangle instead of the unit square.
template <std::size_t Rows, std::size_t Columns>
VectorNet<Rows, Columns> restricted(VectorNet<Rows, Columns> net, double u0, double u1, double v0,
                                    double v1) {
    for (auto& row : net.c) restrict_to(row, u0, u1);
    for (std::size_t j = 0; j < Columns; ++j) {
        std::array<Vec3d, Rows> column;
        for (std::size_t i = 0; i < Rows; ++i) column[i] = net.c[i][j];
        restrict_to(column, v0, v1);
        for (std::size_t i = 0; i < Rows; ++i) net.c[i][j] = column[i];
    }
    return net;
}

/// The length of the largest control vector, which bounds the polynomial (convex hull).
template <std::size_t Rows, std::size_t Columns>
double largest(const VectorNet<Rows, Columns>& net) {
    double most = 0;
    for (const auto& row : net.c) {
        for (const Vec3d& x : row) most = std::max(most, length_squared(x));
    }
    return std::sqrt(most);
}

/// The three second derivatives of a patch as polynomials.
struct Curvature {
    explicit Curvature(const Bicubic<double>& p) {
        const auto at = [&](std::size_t i, std::size_t j) { return p[4 * i + j]; };
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
                uu.c[i][j] = 6.0 * ((at(i, j) + at(i, j + 2)) - 2.0 * at(i, j + 1));
                vv.c[j][i] = 6.0 * ((at(j, i) + at(j + 2, i)) - 2.0 * at(j + 1, i));
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                uv.c[i][j] = 9.0 * ((at(i, j) + at(i + 1, j + 1)) - (at(i, j + 1) + at(i + 1, j)));
            }
        }
    }

    /// The same polynomials over a rectangle.
    Curvature over(double u0, double u1, double v0, double v1) const {
        Curvature part = *this;
        part.uu = restricted(uu, u0, u1, v0, v1);
        part.uv = restricted(uv, u0, u1, v0, v1);
        part.vv = restricted(vv, u0, u1, v0, v1);
        return part;
    }
    SecondDerivatives largest_lengths() const { return {largest(uu), largest(uv), largest(vv)}; }

    VectorNet<4, 2> uu;
    VectorNet<3, 3> uv;
    VectorNet<2, 4> vv;
};

/// A bound on the distance between a triangle and the surface over it. The corners lie on the
/// surface, and their parameters lie in a box of size du x dv. Filip, Magedson, Markot, "Surface
/// algorithms using bounds on derivatives", CAGD 3 (1986), theorem for bivariate linear
/// interpolation. It holds for any triangle in the box: the remainder is half the mean of the
/// second derivative over the corners, and the variances of the corners' parameters are at most
/// (du/2)^2 and (dv/2)^2.
inline double chord_error(const SecondDerivatives& d, double du, double dv) {
    return (du * du * d.uu + 2 * du * dv * d.uv + dv * dv * d.vv) / 8;
}

}  // namespace lancer::splines
