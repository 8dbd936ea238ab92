// Where a bicubic map of the unit square into the plane is zero: the places at which a line, seen
// along itself, meets a bicubic patch.
//
// Newton's method with a start that is proved good: the square is halved until the map, after a
// linear change of the plane, differs from the identity by a contraction. Then it has at most one
// zero there, and Newton's steps find it or show that there is none. Toth, "On ray tracing
// parametric surfaces", SIGGRAPH 1985 (the test, with intervals); Martin, Cohen, Fish, Shirley,
// "Practical ray tracing of trimmed NURBS surfaces", JGT 5(1) 2000 (boxes around flat pieces,
// Newton's method within); the bounds are those of Bernstein coefficients, as in Nishita,
// Sederberg, Kakimoto, "Ray tracing trimmed rational surface patches", SIGGRAPH 1990, whose
// clipping is here the test of the hull in coordinates that follow the piece.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace lancer::splines {

/// 16 control points in the plane, row by row: u along a row, v from row to row.
template <class Real>
struct PlaneNet {
    std::array<Real, 16> x;
    std::array<Real, 16> y;
};

/// A zero at (u, v), each known to within its slack; u and v are in [0, 1].
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

/// Both halves of a row or column of four coefficients, `step` apart.
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

/// Halves of 16 coefficients: along the rows (u), or from row to row.
template <class Real>
void halve(const std::array<Real, 16>& c, bool along_u, std::array<Real, 16>& low,
           std::array<Real, 16>& high) {
    for (std::size_t k = 0; k < 4; ++k) halve(c, along_u ? 4 * k : k, along_u ? 1 : 4, low, high);
}

/// Calls found(PlaneZero) for every zero. Near a place where two zeros meet (the line grazes the
/// patch) or where the map stands still (a pole) what cannot be told apart is reported as one, or
/// several times; its slack then covers it all.
///
/// \param noise  bound on the error of the coefficients: what is nearer to zero than this counts as
///               zero, so that patches with a common border leave no gap between them
template <class Real, class Found>
class PlaneZeros {
  public:
    PlaneZeros(Real noise, Found& found) : noise_(noise), found_(found) {}

    void search(const PlaneNet<Real>& c, Real u0 = 0, Real v0 = 0, Real du = 1, Real dv = 1) {
        using std::abs;
        // The mean slopes, by the corners.
        const Real ux = ((c.x[3] - c.x[0]) + (c.x[15] - c.x[12])) / 2;
        const Real uy = ((c.y[3] - c.y[0]) + (c.y[15] - c.y[12])) / 2;
        const Real vx = ((c.x[12] - c.x[0]) + (c.x[15] - c.x[3])) / 2;
        const Real vy = ((c.y[12] - c.y[0]) + (c.y[15] - c.y[3])) / 2;
        const Real det = ux * vy - vx * uy;
        if (abs(det) > (abs(ux) + abs(vx) + abs(uy) + abs(vy)) * noise_ * 2) {
            const PlaneNet<Real> q = mapped(c, vy / det, -vx / det, -uy / det, ux / det);
            const Real slack_u = (abs(vy) + abs(vx)) / abs(det) * noise_;
            const Real slack_v = (abs(uy) + abs(ux)) / abs(det) * noise_;
            if (is_apart(q.x, slack_u) || is_apart(q.y, slack_v)) return;
            const Real off = contraction(q);
            if (off < Real(0.75)) {
                newton(q, off, slack_u, slack_v, u0, v0, du, dv);
                return;
            }
        } else {
            if (is_apart(c.x, noise_) || is_apart(c.y, noise_)) return;
            if (is_on_a_line(c)) {
                // A flat patch seen edge-on shows nothing. Of one that bends, such a part is where
                // the ray runs along it: no gap there.
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
        halve(c.x, by_u, low.x, high.x);
        halve(c.y, by_u, low.y, high.y);
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
        PlaneNet<Real> q;
        for (std::size_t i = 0; i < 16; ++i) {
            q.x[i] = xx * c.x[i] + xy * c.y[i];
            q.y[i] = yx * c.x[i] + yy * c.y[i];
        }
        return q;
    }

    /// All coefficients on one side of zero, and farther than `slack`: no zero (convex hull).
    static bool is_apart(const std::array<Real, 16>& c, Real slack) {
        Real low = c[0];
        Real high = c[0];
        for (const Real x : c) {
            low = x < low ? x : low;
            high = x > high ? x : high;
        }
        return low > slack || high < -slack;
    }

    /// The largest difference of the map's slopes from the identity's, in the maximum norm.
    static Real contraction(const PlaneNet<Real>& q) {
        using std::abs;
        Real xu = 0, xv = 0, yu = 0, yv = 0;
        const auto keep = [](Real& most, Real x) { most = abs(x) > most ? abs(x) : most; };
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                const std::size_t along = 4 * i + j;
                const std::size_t across = 4 * j + i;
                keep(xu, 3 * (q.x[along + 1] - q.x[along]) - 1);
                keep(yu, 3 * (q.y[along + 1] - q.y[along]));
                keep(xv, 3 * (q.x[across + 4] - q.x[across]));
                keep(yv, 3 * (q.y[across + 4] - q.y[across]) - 1);
            }
        }
        return xu + xv > yu + yv ? xu + xv : yu + yv;
    }

    /// All points on a line, as far as rounding shows.
    bool is_on_a_line(const PlaneNet<Real>& c) const {
        using std::abs;
        std::size_t far = 0;
        const auto reach = [&](std::size_t i) {
            return abs(c.x[i] - c.x[0]) + abs(c.y[i] - c.y[0]);
        };
        for (std::size_t i = 1; i < 16; ++i) far = reach(i) > reach(far) ? i : far;
        const Real dx = c.x[far] - c.x[0];
        const Real dy = c.y[far] - c.y[0];
        const Real size = abs(dx) + abs(dy);
        if (!(size > 4 * noise_)) return false;
        for (std::size_t i = 1; i < 16; ++i) {
            if (abs(dx * (c.y[i] - c.y[0]) - dy * (c.x[i] - c.x[0])) > 2 * noise_ * size)
                return false;
        }
        return true;
    }

    static Real longest_step(const PlaneNet<Real>& c, std::size_t step) {
        using std::abs;
        Real most = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                const std::size_t k = step == 1 ? 4 * i + j : 4 * j + i;
                const Real x = abs(c.x[k + step] - c.x[k]);
                const Real y = abs(c.y[k + step] - c.y[k]);
                const Real size = x > y ? x : y;
                most = size > most ? size : most;
            }
        }
        return most;
    }

    static Real clamped(Real s) { return s < 0 ? Real(0) : s > 1 ? Real(1) : s; }

    /// The one zero of q, which differs from the identity (and a shift) by a contraction with
    /// factor `off` < 1.
    void newton(const PlaneNet<Real>& q, Real off, Real slack_u, Real slack_v, Real u0, Real v0,
                Real du, Real dv) {
        using std::abs;
        constexpr int newton_steps = 12;
        constexpr int steps = 400;  // by then the contraction alone has found it
        Real u = Real(0.5);
        Real v = Real(0.5);
        // The zero may be outside by its slack, which rounding cannot tell from inside.
        const Real beyond_u = 2 * slack_u;
        const Real beyond_v = 2 * slack_v;
        for (int i = 0; i < steps; ++i) {
            const CubicBasis<Real> bu(u);
            const CubicBasis<Real> bv(v);
            const BicubicValue<Real> x(q.x, bu, bv);
            const BicubicValue<Real> y(q.y, bu, bv);
            // A zero is at most |q| / (1 - off) away, and near (u - x, v - y).
            const Real qx = abs(x.value);
            const Real qy = abs(y.value);
            const Real around = off / (1 - off) * (qx > qy ? qx : qy);
            if (u - x.value - around > 1 + beyond_u || u - x.value + around < -beyond_u) return;
            if (v - y.value - around > 1 + beyond_v || v - y.value + around < -beyond_v) return;
            Real step_u = x.value;
            Real step_v = y.value;
            if (i < newton_steps) {
                const Real det = x.du * y.dv - x.dv * y.du;
                step_u = (x.value * y.dv - x.dv * y.value) / det;
                step_v = (x.du * y.value - x.value * y.du) / det;
            }
            const Real next_u = clamped(u - step_u);
            const Real next_v = clamped(v - step_v);
            const bool met = qx <= slack_u && qy <= slack_v;
            const bool stands = abs(next_u - u) <= slack_u / 8 && abs(next_v - v) <= slack_v / 8;
            u = next_u;
            v = next_v;
            if (met) break;
            // Newton's steps may come to rest at the border with the zero elsewhere in the square;
            // where the contraction rests there is none.
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
