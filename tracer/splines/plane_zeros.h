// The zeros of a bicubic map from the unit square to the plane. With a bicubic patch projected
// along a line, they are the crossings of the line with the patch.
//
// This is Newton's method with a proved start. The square is halved until the map, after a linear
// change of the plane, differs from the identity by a contraction. Then it has at most one zero
// there, and Newton's steps find it or show that there is none. Toth, "On ray tracing parametric
// surfaces", SIGGRAPH 1985 (this test, with intervals); Martin, Cohen, Fish, Shirley, "Practical
// ray tracing of trimmed NURBS surfaces", JGT 5(1) 2000 (boxes around flat pieces, Newton's method
// inside). The bounds come from Bernstein coefficients, as in Nishita, Sederberg, Kakimoto, "Ray
// tracing trimmed rational surface patches", SIGGRAPH 1990; in place of their clipping, the convex
// hull is tested in coordinates along the piece's directions.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "tracer/numerics/lanes.h"

namespace lancer::splines {

/// 16 control points in the plane, row by row: u along a row, v from row to row. Both coordinates
/// of a point are adjacent, because nearly all operations act on both (SIMD).
template <class Real>
using PlaneNet = std::array<std::array<Real, 2>, 16>;

/// A zero at (u, v), in [0, 1]^2. The slacks bound the errors of u and v.
template <class Real>
struct PlaneZero {
    Real u, v;
    Real slack_u, slack_v;
};

/// Bernstein polynomials of degree 3 and their derivatives at s.
template <class Real>
struct CubicBasis {
    std::array<Real, 4> value;
    std::array<Real, 4> slope;

    explicit CubicBasis(Real s) {
        const Real r = 1 - s;
        const Real rr = r * r;
        const Real rs = r * s;
        const Real ss = s * s;
        value = {rr * r, 3 * rr * s, 3 * r * ss, ss * s};
        slope = {-3 * rr, 3 * (rr - 2 * rs), 3 * (2 * rs - ss), 3 * ss};
    }
};

/// Value and both derivatives of one coordinate of a bicubic.
template <class Real>
struct BicubicValue {
    Real value, du, dv;

    BicubicValue(const std::array<Real, 16>& c, const CubicBasis<Real>& u,
                 const CubicBasis<Real>& v)
        : value(0), du(0), dv(0) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Real* row = &c[4 * i];
            const Real at = row[0] * u.value[0] + row[1] * u.value[1] + row[2] * u.value[2] +
                            row[3] * u.value[3];
            const Real slope = row[0] * u.slope[0] + row[1] * u.slope[1] + row[2] * u.slope[2] +
                               row[3] * u.slope[3];
            value += v.value[i] * at;
            du += v.value[i] * slope;
            dv += v.slope[i] * at;
        }
    }
};

/// The same for points in the plane.
template <class Real>
struct PlaneValue {
    std::array<Real, 2> value, du, dv;

    PlaneValue(const PlaneNet<Real>& c, const CubicBasis<Real>& u, const CubicBasis<Real>& v) {
        Two<Real> sum(Real(0));
        Two<Real> sum_du(Real(0));
        Two<Real> sum_dv(Real(0));
        for (std::size_t i = 0; i < 4; ++i) {
            const auto weighted = [&](const std::array<Real, 4>& w) {
                const auto term = [&](std::size_t j) {
                    return Two<Real>(c[4 * i + j]) * Two<Real>(w[j]);
                };
                return term(0) + term(1) + term(2) + term(3);
            };
            const Two<Real> at = weighted(u.value);
            const Two<Real> slope = weighted(u.slope);
            sum = sum + Two<Real>(v.value[i]) * at;
            sum_du = sum_du + Two<Real>(v.value[i]) * slope;
            sum_dv = sum_dv + Two<Real>(v.slope[i]) * at;
        }
        value = sum.numbers();
        du = sum_du.numbers();
        dv = sum_dv.numbers();
    }
};

/// Both halves of a row or column: four coefficients with the indices first, first + step, ...
template <class Real>
void halve(const std::array<Real, 16>& c, std::size_t first, std::size_t step,
           std::array<Real, 16>& left, std::array<Real, 16>& right) {
    const Real a = c[first];
    const Real b = c[first + step];
    const Real d = c[first + 2 * step];
    const Real e = c[first + 3 * step];
    const Real ab = (a + b) / 2;
    const Real bd = (b + d) / 2;
    const Real de = (d + e) / 2;
    const Real abd = (ab + bd) / 2;
    const Real bde = (bd + de) / 2;
    const Real middle = (abd + bde) / 2;
    left[first] = a;
    left[first + step] = ab;
    left[first + 2 * step] = abd;
    left[first + 3 * step] = right[first] = middle;
    right[first + step] = bde;
    right[first + 2 * step] = de;
    right[first + 3 * step] = e;
}

/// Both halves of 16 coefficients: along the rows (u), or from row to row (v).
template <class Real>
void halve(const std::array<Real, 16>& c, bool along_u, std::array<Real, 16>& low,
           std::array<Real, 16>& high) {
    for (std::size_t k = 0; k < 4; ++k) halve(c, along_u ? 4 * k : k, along_u ? 1 : 4, low, high);
}

/// The same for points in the plane.
template <class Real>
void halve(const PlaneNet<Real>& c, bool along_u, PlaneNet<Real>& low, PlaneNet<Real>& high) {
    const std::size_t step = along_u ? 1 : 4;
    const auto mean = [](const Two<Real>& a, const Two<Real>& b) {
        return (a + b) * Two<Real>(Real(0.5));
    };
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t first = along_u ? 4 * k : k;
        const Two<Real> a(c[first]);
        const Two<Real> b(c[first + step]);
        const Two<Real> d(c[first + 2 * step]);
        const Two<Real> e(c[first + 3 * step]);
        const Two<Real> ab = mean(a, b);
        const Two<Real> bd = mean(b, d);
        const Two<Real> de = mean(d, e);
        const Two<Real> abd = mean(ab, bd);
        const Two<Real> bde = mean(bd, de);
        low[first] = a.numbers();
        low[first + step] = ab.numbers();
        low[first + 2 * step] = abd.numbers();
        low[first + 3 * step] = high[first] = mean(abd, bde).numbers();
        high[first + step] = bde.numbers();
        high[first + 2 * step] = de.numbers();
        high[first + 3 * step] = e.numbers();
    }
}

/// Calls found(PlaneZero) for every zero. Two zeros may be closer than rounding errors, where the
/// line grazes the patch; or the map may have zero derivatives, at a pole. Such zeros are reported
/// once or several times, and the slack covers all of them.
///
/// \param noise  bound on the error of the coefficients. Values nearer to 0 than this count as 0,
/// so
///               that patches with a common border leave no gap between them
template <class Real, class Found>
class PlaneZeros {
  public:
    PlaneZeros(Real noise, Found& found) : noise_(noise), found_(found) {}

    void search(const PlaneNet<Real>& c, Real u0 = 0, Real v0 = 0, Real du = 1, Real dv = 1) {
        using std::abs;
        // The mean slopes, from the corners.
        const Real ux = ((c[3][0] - c[0][0]) + (c[15][0] - c[12][0])) / 2;
        const Real uy = ((c[3][1] - c[0][1]) + (c[15][1] - c[12][1])) / 2;
        const Real vx = ((c[12][0] - c[0][0]) + (c[15][0] - c[3][0])) / 2;
        const Real vy = ((c[12][1] - c[0][1]) + (c[15][1] - c[3][1])) / 2;
        const Real det = ux * vy - vx * uy;
        if (abs(det) > (abs(ux) + abs(vx) + abs(uy) + abs(vy)) * noise_ * 2) {
            const PlaneNet<Real> q = mapped(c, vy / det, -vx / det, -uy / det, ux / det);
            const Real slack_u = (abs(vy) + abs(vx)) / abs(det) * noise_;
            const Real slack_v = (abs(uy) + abs(ux)) / abs(det) * noise_;
            if (is_apart(q, {slack_u, slack_v})) return;
            const Real off = contraction(q);
            if (off < Real(0.75)) {
                newton(q, off, slack_u, slack_v, u0, v0, du, dv);
                return;
            }
        } else {
            if (is_apart(c, {noise_, noise_})) return;
            if (is_on_a_line(c)) {
                // A flat patch that is seen edge-on is invisible. In a curved patch, the ray runs
                // along such a part; it is reported, to leave no gap.
                if (du < 1 || dv < 1) report_all(u0, v0, du, dv);
                return;
            }
        }
        const Real along_u = longest_step(c, 1);
        const Real along_v = longest_step(c, 4);
        const bool by_u = along_u >= along_v;
        if (!((by_u ? along_u : along_v) > noise_)) {
            report_all(u0, v0, du, dv);
            return;
        }
        PlaneNet<Real> low;
        PlaneNet<Real> high;
        halve(c, by_u, low, high);
        if (by_u) {
            du /= 2;
            search(low, u0, v0, du, dv);
            search(high, u0 + du, v0, du, dv);
        } else {
            dv /= 2;
            search(low, u0, v0, du, dv);
            search(high, u0, v0 + dv, du, dv);
        }
    }

  private:
    void report_all(Real u0, Real v0, Real du, Real dv) {
        found_(PlaneZero<Real>{u0 + du / 2, v0 + dv / 2, du / 2, dv / 2});
    }

    static PlaneNet<Real> mapped(const PlaneNet<Real>& c, Real xx, Real xy, Real yx, Real yy) {
        const Two<Real> by_x(std::array{xx, yx});
        const Two<Real> by_y(std::array{xy, yy});
        PlaneNet<Real> q;
        for (std::size_t i = 0; i < 16; ++i)
            q[i] = (by_x * Two<Real>(c[i][0]) + by_y * Two<Real>(c[i][1])).numbers();
        return q;
    }

    /// Whether in one coordinate all points lie on one side of 0, farther from it than the slack.
    /// Then there is no zero (convex hull).
    static bool is_apart(const PlaneNet<Real>& c, const std::array<Real, 2>& slack) {
        Two<Real> low(c[0]);
        Two<Real> high(c[0]);
        for (std::size_t i = 1; i < 16; ++i) {
            low = smaller(Two<Real>(c[i]), low);
            high = larger(Two<Real>(c[i]), high);
        }
        const Two<Real> most(slack);
        return (less(most, low) | less(high, Two<Real>(Real(0)) - most)) != 0;
    }

    /// The larger of |x| and `most`, for each number.
    static Two<Real> larger_size(const Two<Real>& x, const Two<Real>& most) {
        return larger(x, larger(Two<Real>(Real(0)) - x, most));
    }
    static Two<Real> difference(const PlaneNet<Real>& c, std::size_t to, std::size_t from) {
        return Two<Real>(c[to]) - Two<Real>(c[from]);
    }

    /// A bound on the difference of the map's derivative from the identity, in the maximum norm.
    static Real contraction(const PlaneNet<Real>& q) {
        const Two<Real> three(Real(3));
        const Two<Real> one_x(std::array{Real(1), Real(0)});
        const Two<Real> one_y(std::array{Real(0), Real(1)});
        Two<Real> by_u(Real(0));
        Two<Real> by_v(Real(0));
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                const std::size_t along = 4 * i + j;
                const std::size_t across = 4 * j + i;
                by_u = larger_size(three * difference(q, along + 1, along) - one_x, by_u);
                by_v = larger_size(three * difference(q, across + 4, across) - one_y, by_v);
            }
        }
        const std::array<Real, 2> row = (by_u + by_v).numbers();
        return row[0] > row[1] ? row[0] : row[1];
    }

    /// Whether all points lie on a line, up to rounding.
    bool is_on_a_line(const PlaneNet<Real>& c) const {
        using std::abs;
        std::size_t far = 0;
        const auto reach = [&](std::size_t i) {
            return abs(c[i][0] - c[0][0]) + abs(c[i][1] - c[0][1]);
        };
        for (std::size_t i = 1; i < 16; ++i) far = reach(i) > reach(far) ? i : far;
        const Real dx = c[far][0] - c[0][0];
        const Real dy = c[far][1] - c[0][1];
        const Real size = abs(dx) + abs(dy);
        if (!(size > 4 * noise_)) return false;
        for (std::size_t i = 1; i < 16; ++i) {
            if (abs(dx * (c[i][1] - c[0][1]) - dy * (c[i][0] - c[0][0])) > 2 * noise_ * size)
                return false;
        }
        return true;
    }

    static Real longest_step(const PlaneNet<Real>& c, std::size_t step) {
        Two<Real> most(Real(0));
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                const std::size_t k = step == 1 ? 4 * i + j : 4 * j + i;
                most = larger_size(difference(c, k + step, k), most);
            }
        }
        const std::array<Real, 2> size = most.numbers();
        return size[0] > size[1] ? size[0] : size[1];
    }

    static Real clamped(Real s) { return s < 0 ? Real(0) : s > 1 ? Real(1) : s; }

    /// Finds the only zero of q, which differs from the identity plus a shift by a contraction with
    /// the factor `off` < 1.
    void newton(const PlaneNet<Real>& q, Real off, Real slack_u, Real slack_v, Real u0, Real v0,
                Real du, Real dv) {
        using std::abs;
        constexpr int newton_steps = 12;
        constexpr int steps = 400;  // enough for the contraction alone
        Real u = Real(0.5);
        Real v = Real(0.5);
        // The zero may lie outside by its slack: rounding cannot tell that from inside.
        const Real beyond_u = 2 * slack_u;
        const Real beyond_v = 2 * slack_v;
        for (int i = 0; i < steps; ++i) {
            const CubicBasis<Real> bu(u);
            const CubicBasis<Real> bv(v);
            const PlaneValue<Real> at(q, bu, bv);
            const auto [x, y] = at.value;
            // A zero is at most |q| / (1 - off) away, and near (u - x, v - y).
            const Real qx = abs(x);
            const Real qy = abs(y);
            const Real around = off / (1 - off) * (qx > qy ? qx : qy);
            if (u - x - around > 1 + beyond_u || u - x + around < -beyond_u) return;
            if (v - y - around > 1 + beyond_v || v - y + around < -beyond_v) return;
            Real step_u = x;
            Real step_v = y;
            if (i < newton_steps) {
                const Real det = at.du[0] * at.dv[1] - at.dv[0] * at.du[1];
                step_u = (x * at.dv[1] - at.dv[0] * y) / det;
                step_v = (at.du[0] * y - x * at.du[1]) / det;
            }
            const Real next_u = clamped(u - step_u);
            const Real next_v = clamped(v - step_v);
            const bool met = qx <= slack_u && qy <= slack_v;
            const bool stands = abs(next_u - u) <= slack_u / 8 && abs(next_v - v) <= slack_v / 8;
            u = next_u;
            v = next_v;
            if (met) break;
            // Newton's steps may stop at the border although the zero is elsewhere in the square.
            // If the contraction's steps stop there, there is no zero.
            if (stands && i < newton_steps) {
                i = newton_steps - 1;
            } else if (stands) {
                if (qx > 2 * beyond_u || qy > 2 * beyond_v) return;
                break;
            }
        }
        const Real factor = 1 / (1 - off);
        found_(PlaneZero<Real>{u0 + du * u, v0 + dv * v, du * factor * 2 * slack_u,
                               dv * factor * 2 * slack_v});
    }

    Real noise_;
    Found& found_;
};

}  // namespace lancer::splines
