// Where eight maps of the unit square into the plane are zero: splines/plane_zeros.h for lanes, the
// same operations in the same order. What is rare, and lanes that go on alone, is left to that.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// PlaneNet<double>
struct PlaneNets {
    Numbers c[16][2];
};

/// A part of the unit square of each lane.
struct Squares {
    Numbers u, v, du, dv;
};

/// PlaneZero<double>
struct PlaneZeroPlaces {
    Numbers u, v, slack_u, slack_v;
};

/// PlaneValue<double>
struct PlaneValues {
    Numbers value[2], du[2], dv[2];

    LANCER_INLINE PlaneValues(const PlaneNets& net, const CubicBases& u, const CubicBases& v) {
        for (int k = 0; k < 2; ++k) {
            value[k] = du[k] = dv[k] = all(0.0);
            for (int i = 0; i < 4; ++i) {
                const Numbers& a = net.c[4 * i][k];
                const Numbers& b = net.c[4 * i + 1][k];
                const Numbers& c = net.c[4 * i + 2][k];
                const Numbers& d = net.c[4 * i + 3][k];
                const Numbers at = weighted(a, b, c, d, u.value);
                const Numbers slope = weighted(a, b, c, d, u.slope);
                value[k] = value[k] + v.value[i] * at;
                du[k] = du[k] + v.value[i] * slope;
                dv[k] = dv[k] + v.slope[i] * at;
            }
        }
    }
};

/// PlaneZeros<double> of eight rays.
///
/// \tparam Found  found(mask, places): zeros, one for each lane of the mask
/// \tparam Rest   rest(mask, net, squares): lanes whose part of the square is left to scalar code
template <class Found, class Rest>
class PlaneZeroSearch {
  public:
    PlaneZeroSearch(const Numbers& noise, Found& found, Rest& rest)
        : noise_(noise), found_(found), rest_(rest) {}

    void search(const PlaneNets& net, Mask mask, const Squares& square, int depth = 0) {
        const auto& c = net.c;
        const Numbers half = all(0.5);
        const Numbers ux = ((c[3][0] - c[0][0]) + (c[15][0] - c[12][0])) * half;
        const Numbers uy = ((c[3][1] - c[0][1]) + (c[15][1] - c[12][1])) * half;
        const Numbers vx = ((c[12][0] - c[0][0]) + (c[15][0] - c[3][0])) * half;
        const Numbers vy = ((c[12][1] - c[0][1]) + (c[15][1] - c[3][1])) * half;
        const Numbers det = ux * vy - vx * uy;
        const Numbers sizes = absolute(ux) + absolute(vx) + absolute(uy) + absolute(vy);
        const Mask flat = mask & ~less(sizes * noise_ * all(2.0), absolute(det));
        mask &= ~flat;
        if (flat != 0) {
            const Mask apart = is_apart(net, noise_, noise_);
            if ((flat & ~apart) != 0) rest_(flat & ~apart, net, square);
        }
        if (mask == 0) return;
        {
            PlaneNets q;
            map(net, vy / det, -vx / det, -uy / det, ux / det, q);
            const Numbers size = absolute(det);
            const Numbers slack_u = (absolute(vy) + absolute(vx)) / size * noise_;
            const Numbers slack_v = (absolute(uy) + absolute(ux)) / size * noise_;
            mask &= ~is_apart(q, slack_u, slack_v);
            if (mask == 0) return;
            const Numbers off = contraction(q);
            const Mask contracts = mask & less(off, all(0.75));
            mask &= ~contracts;
            if (contracts != 0) {
                const Mask left = newton(q, off, slack_u, slack_v, contracts, square);
                if (left != 0) rest_(left, net, square);
            }
            if (mask == 0) return;
        }
        if (depth == most_depth || __builtin_popcount(mask) < least_lanes) {
            rest_(mask, net, square);
            return;
        }
        const Numbers along_u = longest_step(net, 1);
        const Numbers along_v = longest_step(net, 4);
        const Mask by_u = at_most(along_v, along_u);
        const Mask stuck = mask & ~less(noise_, select(by_u, along_u, along_v));
        if (stuck != 0) rest_(stuck, net, square);
        mask &= ~stuck;
        if ((mask & by_u) != 0) halve(net, mask & by_u, square, true, depth);
        if ((mask & ~by_u) != 0) halve(net, mask & ~by_u, square, false, depth);
    }

  private:
    static constexpr int most_depth = 24;
    /// With fewer, scalar code takes both coordinates side by side.
    static constexpr int least_lanes = 2;

    void halve(const PlaneNets& net, Mask mask, Squares square, bool along_u, int depth) {
        if (__builtin_popcount(mask) < least_lanes) {
            rest_(mask, net, square);
            return;
        }
        PlaneNets low;
        PlaneNets high;
        const Numbers half = all(0.5);
        const int step = along_u ? 1 : 4;
        for (int k = 0; k < 4; ++k) {
            const int first = along_u ? 4 * k : k;
            for (int i = 0; i < 2; ++i) {
                const Numbers a = net.c[first][i];
                const Numbers b = net.c[first + step][i];
                const Numbers d = net.c[first + 2 * step][i];
                const Numbers e = net.c[first + 3 * step][i];
                const Numbers ab = (a + b) * half;
                const Numbers bd = (b + d) * half;
                const Numbers de = (d + e) * half;
                const Numbers abd = (ab + bd) * half;
                const Numbers bde = (bd + de) * half;
                low.c[first][i] = a;
                low.c[first + step][i] = ab;
                low.c[first + 2 * step][i] = abd;
                low.c[first + 3 * step][i] = high.c[first][i] = (abd + bde) * half;
                high.c[first + step][i] = bde;
                high.c[first + 2 * step][i] = de;
                high.c[first + 3 * step][i] = e;
            }
        }
        if (along_u)
            square.du = square.du * half;
        else
            square.dv = square.dv * half;
        search(low, mask, square, depth + 1);
        if (along_u)
            square.u = square.u + square.du;
        else
            square.v = square.v + square.dv;
        search(high, mask, square, depth + 1);
    }

    LANCER_INLINE static void map(const PlaneNets& net, const Numbers& xx, const Numbers& xy,
                                  const Numbers& yx, const Numbers& yy, PlaneNets& q) {
        for (int i = 0; i < 16; ++i) {
            const Numbers x = net.c[i][0];
            const Numbers y = net.c[i][1];
            q.c[i][0] = xx * x + xy * y;
            q.c[i][1] = yx * x + yy * y;
        }
    }

    LANCER_INLINE static Mask is_apart(const PlaneNets& net, const Numbers& slack_x,
                                       const Numbers& slack_y) {
        Mask apart = 0;
        for (int k = 0; k < 2; ++k) {
            Numbers low = net.c[0][k];
            Numbers high = low;
            for (int i = 1; i < 16; ++i) {
                low = smaller(net.c[i][k], low);
                high = larger(net.c[i][k], high);
            }
            const Numbers& most = k == 0 ? slack_x : slack_y;
            apart |= less(most, low) | less(high, -most);
        }
        return apart;
    }

    LANCER_INLINE static Numbers contraction(const PlaneNets& q) {
        const Numbers three = all(3.0);
        const Numbers one = all(1.0);
        const Numbers zero = all(0.0);
        Numbers row[2];
        for (int k = 0; k < 2; ++k) {
            Numbers by_u = zero;
            Numbers by_v = zero;
            for (int i = 0; i < 4; ++i) {
                for (int j = 0; j < 3; ++j) {
                    const int along = 4 * i + j;
                    const int across = 4 * j + i;
                    const Numbers du = three * (q.c[along + 1][k] - q.c[along][k]);
                    const Numbers dv = three * (q.c[across + 4][k] - q.c[across][k]);
                    by_u = larger(absolute(k == 0 ? du - one : du), by_u);
                    by_v = larger(absolute(k == 1 ? dv - one : dv), by_v);
                }
            }
            row[k] = by_u + by_v;
        }
        return larger(row[0], row[1]);
    }

    LANCER_INLINE static Numbers longest_step(const PlaneNets& net, int step) {
        Numbers most = all(0.0);
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 3; ++j) {
                const int at = step == 1 ? 4 * i + j : 4 * j + i;
                for (int k = 0; k < 2; ++k)
                    most = larger(absolute(net.c[at + step][k] - net.c[at][k]), most);
            }
        }
        return most;
    }

    LANCER_INLINE static Numbers clamped(const Numbers& s) {
        const Numbers zero = all(0.0);
        const Numbers one = all(1.0);
        return select(less(s, zero), zero, select(less(one, s), one, s));
    }

    /// \return lanes that do not come to an end by Newton's steps alone
    LANCER_INLINE Mask newton(const PlaneNets& q, const Numbers& off, const Numbers& slack_u,
                              const Numbers& slack_v, Mask mask, const Squares& square) {
        constexpr int newton_steps = 12;
        const Numbers one = all(1.0);
        const Numbers two = all(2.0);
        Numbers u = all(0.5);
        Numbers v = all(0.5);
        const Numbers beyond_u = two * slack_u;
        const Numbers beyond_v = two * slack_v;
        const Numbers spread = off / (one - off);
        Mask met = 0;
        Mask left = 0;
        for (int i = 0; i < newton_steps && mask != 0; ++i) {
            const PlaneValues at(q, CubicBases(u), CubicBases(v));
            const Numbers& x = at.value[0];
            const Numbers& y = at.value[1];
            const Numbers qx = absolute(x);
            const Numbers qy = absolute(y);
            const Numbers around = spread * larger(qx, qy);
            mask &= ~(less(one + beyond_u, u - x - around) | less(u - x + around, -beyond_u) |
                      less(one + beyond_v, v - y - around) | less(v - y + around, -beyond_v));
            const Numbers det = at.du[0] * at.dv[1] - at.dv[0] * at.du[1];
            const Numbers step_u = (x * at.dv[1] - at.dv[0] * y) / det;
            const Numbers step_v = (at.du[0] * y - x * at.du[1]) / det;
            const Numbers next_u = clamped(u - step_u);
            const Numbers next_v = clamped(v - step_v);
            const Mask here = mask & at_most(qx, slack_u) & at_most(qy, slack_v);
            const Numbers eighth = all(0.125);
            const Mask stands = at_most(absolute(next_u - u), slack_u * eighth) &
                                at_most(absolute(next_v - v), slack_v * eighth);
            u = select(mask, next_u, u);
            v = select(mask, next_v, v);
            met |= here;
            mask &= ~here;
            left |= mask & stands;
            mask &= ~stands;
        }
        left |= mask;
        if (met == 0) return left;
        const Numbers factor = one / (one - off);
        found_(met, PlaneZeroPlaces{square.u + square.du * u, square.v + square.dv * v,
                                    square.du * factor * two * slack_u,
                                    square.dv * factor * two * slack_v});
        return left;
    }

    const Numbers& noise_;
    Found& found_;
    Rest& rest_;
};

}  // namespace lancer::wide::LANCER_LEVEL
