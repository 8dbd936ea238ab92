#include "tracer/splines/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lancer::splines {
namespace {

/// The largest of (x y a + y z b + z x c) / 2 over weights x + y + z = 1, for a, b, c >= 0: twice
/// this is the square of a triangle's circumradius over 4, its edges squared being a, b, c; or of
/// half its longest edge, when it is obtuse.
double largest_mean(double a, double b, double c) {
    const double most = std::max({a, b, c});
    if (2 * most >= a + b + c) return most / 8;
    return a * b * c / (2 * (2 * (a * b + b * c + c * a) - (a * a + b * b + c * c)));
}

/// (q at the edges between corners 0-1, 1-2, 2-0) of the form uu du^2 + 2 uv du dv + vv dv^2.
std::array<double, 3> at_edges(double uu, double uv, double vv, const std::array<Vec2d, 3>& c) {
    std::array<double, 3> q{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2d e = c[(i + 1) % 3] - c[i];
        q[i] = e.x * e.x * uu + 2 * e.x * e.y * uv + e.y * e.y * vv;
    }
    return q;
}

Vec2d extent(const std::array<Vec2d, 3>& c) {
    const auto [u0, u1] = std::minmax({c[0].x, c[1].x, c[2].x});
    const auto [v0, v1] = std::minmax({c[0].y, c[1].y, c[2].y});
    return {u1 - u0, v1 - v0};
}

}  // namespace

Certificate::Certificate(const Bicubic<double>& p, const Curvature& curvature, double u0, double u1,
                         double v0, double v1, double margin_u, double margin_v)
    : curvature_(curvature.over(u0 - margin_u, u1 + margin_u, v0 - margin_v, v1 + margin_v)),
      margin_u_(margin_u),
      margin_v_(margin_v),
      reach_u_((u1 - u0) / 2 + margin_u),
      reach_v_((v1 - v0) / 2 + margin_v) {
    const PatchSample<double> centre =
        sample(p, Place<double>((u0 + u1) / 2), Place<double>((v0 + v1) / 2));
    const Vec3d n = cross(centre.du, centre.dv);
    const double nn = length_squared(n);
    if (!(nn > 1e-8 * length_squared(centre.du) * length_squared(centre.dv))) return;
    regular_ = true;
    n_ = n / std::sqrt(nn);
    rows_[0] = cross(centre.dv, n) / nn;
    rows_[1] = cross(n, centre.du) / nn;
    normal_ = along(n_);
    a_ = along(rows_[0]);
    b_ = along(rows_[1]);
    const SecondDerivatives most = curvature_.largest_lengths();
    slope_u_ = centre.du;
    slope_v_ = centre.dv;
    off_u_ = most.uu * reach_u_ + most.uv * reach_v_;
    off_v_ = most.uv * reach_u_ + most.vv * reach_v_;
}

Certificate::Second Certificate::along(const Vec3d& direction) const {
    const auto range = [&](const auto& net) {
        double low = dot(direction, net.c[0][0]);
        double high = low;
        for (const auto& row : net.c) {
            for (const Vec3d& x : row) {
                low = std::min(low, dot(direction, x));
                high = std::max(high, dot(direction, x));
            }
        }
        return Range{(low + high) / 2, (high - low) / 2};
    };
    return {range(curvature_.uu), range(curvature_.uv), range(curvature_.vv)};
}

/// What the second derivatives' variation may add: the spread of the corners' parameters about
/// their mean is at most (width / 2)^2.
double Certificate::radius_part(const Second& second, const std::array<Vec2d, 3>& at) {
    const Vec2d e = extent(at);
    return (e.x * e.x * second.uu.radius + 2 * e.x * e.y * second.uv.radius +
            e.y * e.y * second.vv.radius) /
           8;
}

/// Bound on a coordinate of S - L where the corners lie on S: for second derivatives that do not
/// vary it is the sum over edges of the corners' weights times the second derivative along the
/// edge, halved.
double Certificate::chord(const Second& second, const std::array<Vec2d, 3>& at) {
    const auto q = at_edges(second.uu.mid, second.uv.mid, second.vv.mid, at);
    const auto up = [](double x) { return std::max(x, 0.0); };
    return std::max(largest_mean(up(q[0]), up(q[1]), up(q[2])),
                    largest_mean(up(-q[0]), up(-q[1]), up(-q[2]))) +
           radius_part(second, at);
}

bool Certificate::find_shift(double along_a, double along_b, Shift& shift) const {
    // The slopes in the coordinates a, b are the identity but for this.
    const auto off = [&](const Second& s) {
        return std::array{s.uu.largest() * reach_u_ + s.uv.largest() * reach_v_,
                          s.uv.largest() * reach_u_ + s.vv.largest() * reach_v_};
    };
    const auto [au, av] = off(a_);
    const auto [bu, bv] = off(b_);
    // The smallest box that the fixed point map leads into itself: r = along + off r.
    const double det = (1 - au) * (1 - bv) - av * bu;
    if (!(au < 1 && bv < 1 && det > 0)) return false;
    shift.u = ((1 - bv) * along_a + av * along_b) / det;
    shift.v = ((1 - au) * along_b + bu * along_a) / det;
    shift.skew_u = au * shift.u + av * shift.v;
    shift.skew_v = bu * shift.u + bv * shift.v;
    return shift.u <= margin_u_ && shift.v <= margin_v_;
}

/// What the shift does along N.
double Certificate::tilt(const Shift& shift) const {
    return (normal_.uu.largest() * reach_u_ + normal_.uv.largest() * reach_v_) * shift.u +
           (normal_.uv.largest() * reach_u_ + normal_.vv.largest() * reach_v_) * shift.v;
}

/// How far a shift may lead out of the patch over a border from which the corners have these
/// depths, but for its skew. `out`: the corners' own shift over it; `sign`: which way it is.
double Certificate::beyond(const Second& second, double sign, const std::array<double, 3>& out,
                           const std::array<Vec2d, 3>& at, const std::array<double, 3>& depth) {
    const auto q = at_edges(second.uu.mid, second.uv.mid, second.vv.mid, at);
    // Of weights x, y, z: the sum of x y g over the edges and of x (out - depth) over the corners.
    // Each edge is charged to its deeper corner; along the border x y <= 1/4.
    std::array<double, 3> charged{};
    double along = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const double g = std::max(0.0, sign * q[i] / 2);
        const std::size_t deeper = depth[i] > depth[j] ? i : j;
        if (depth[deeper] == 0) {
            along = std::max(along, g / 4);
        } else {
            charged[deeper] = std::max(charged[deeper], g);
        }
    }
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, charged[i] + out[i] - depth[i]);
    return along + most + radius_part(second, at);
}

/// How much of a shift of at most `size` is cut off at the two borders across `axis`.
double Certificate::slide(const ChordTriangle& t, int axis, double size, double skew) const {
    const Second& second = axis == 0 ? a_ : b_;
    double most = 0;
    for (const double sign : {-1.0, 1.0}) {
        // S - L is minus half the second derivatives, and the shift goes back by S - L.
        std::array<double, 3> out{};
        std::array<double, 3> depth{};
        for (std::size_t i = 0; i < 3; ++i) {
            out[i] = -sign * dot(rows_[axis], t.off[i]);
            depth[i] = sign < 0 ? t.at[i][axis] : 1 - t.at[i][axis];
        }
        if (*std::ranges::min_element(depth) >= size) continue;
        most = std::max(most, std::min(size, beyond(second, sign, out, t.at, depth) + skew));
    }
    return most;
}

/// What the shift, cut off at the border, misses along the surface. Where it is cut off in one
/// parameter, the other is shifted further to the nearest place.
double Certificate::cut_off(const ChordTriangle& t, Shift& shift) const {
    const double cut_u = slide(t, 0, shift.u, shift.skew_u);
    const double cut_v = slide(t, 1, shift.v, shift.skew_v);
    if (cut_u == 0 && cut_v == 0) return 0;
    const double between = dot(slope_u_, slope_v_);
    const double more_u = cut_v * std::abs(between) / length_squared(slope_u_);
    const double more_v = cut_u * std::abs(between) / length_squared(slope_v_);
    if (cut_u == 0 && shift.u + more_u <= margin_u_ &&
        slide(t, 0, shift.u + more_u, shift.skew_u + more_u) == 0) {
        shift.u += more_u;
        const double across = length(slope_v_ - slope_u_ * (between / length_squared(slope_u_)));
        return cut_v * (across + off_v_) + more_u * off_u_;
    }
    if (cut_v == 0 && shift.v + more_v <= margin_v_ &&
        slide(t, 1, shift.v + more_v, shift.skew_v + more_v) == 0) {
        shift.v += more_v;
        const double across = length(slope_u_ - slope_v_ * (between / length_squared(slope_v_)));
        return cut_u * (across + off_u_) + more_v * off_v_;
    }
    return cut_u * (length(slope_u_) + off_u_) + cut_v * (length(slope_v_) + off_v_);
}

double Certificate::distance(const ChordTriangle& t) const {
    const auto most = [&](const Vec3d& direction) {
        return std::max({std::abs(dot(direction, t.off[0])), std::abs(dot(direction, t.off[1])),
                         std::abs(dot(direction, t.off[2]))});
    };
    Shift s{};
    if (!regular_ ||
        !find_shift(chord(a_, t.at) + most(rows_[0]), chord(b_, t.at) + most(rows_[1]), s))
        return std::numeric_limits<double>::infinity();
    const double along_surface = cut_off(t, s);
    return std::hypot(chord(normal_, t.at) + most(n_) + tilt(s), along_surface);
}

double Certificate::cell_distance(double du, double dv, bool rising) const {
    // Both triangles have the same edges, and so the same bound.
    const std::array<Vec2d, 3> at{rising ? std::array{Vec2d(0, 0), Vec2d(du, 0), Vec2d(du, dv)}
                                         : std::array{Vec2d(0, 0), Vec2d(du, 0), Vec2d(0, dv)}};
    Shift s{};
    if (!regular_ || !find_shift(chord(a_, at), chord(b_, at), s))
        return std::numeric_limits<double>::infinity();
    return chord(normal_, at) + tilt(s);
}

ChordTriangle chord_triangle(const Bicubic<double>& p, const std::array<Vec2d, 3>& at) {
    ChordTriangle t{at, {}, {Vec3d(0), Vec3d(0), Vec3d(0)}};
    for (std::size_t i = 0; i < 3; ++i)
        t.point[i] = sample(p, Place<double>(at[i].x), Place<double>(at[i].y)).point;
    return t;
}

bool is_near(const Bicubic<double>& p, const Curvature& curvature, const ChordTriangle& t,
             double tolerance, int halvings) {
    const auto [u0, u1] = std::minmax({t.at[0].x, t.at[1].x, t.at[2].x});
    const auto [v0, v1] = std::minmax({t.at[0].y, t.at[1].y, t.at[2].y});
    double off = 0;
    for (const Vec3d& d : t.off) off = std::max(off, length(d));
    const auto plain = curvature.over(u0, u1, v0, v1).largest_lengths();
    const double straight = off + chord_error(plain, u1 - u0, v1 - v0);
    if (straight <= tolerance) return true;
    const PatchSample<double> centre =
        sample(p, Place<double>((u0 + u1) / 2), Place<double>((v0 + v1) / 2));
    const double area = length(cross(centre.du, centre.dv));
    if (area > 0) {
        // Half as much again as the shift if the slopes did not change.
        const Certificate around(p, curvature, u0, u1, v0, v1,
                                 1.5 * straight * length(centre.dv) / area,
                                 1.5 * straight * length(centre.du) / area);
        if (around.distance(t) <= tolerance) return true;
    }
    if (halvings == 0) return false;
    std::array<Vec2d, 3> at{};
    std::array<Vec3d, 3> point{};
    std::array<Vec3d, 3> middle_off{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        at[i] = (t.at[i] + t.at[j]) / 2.0;
        point[i] = (t.point[i] + t.point[j]) / 2.0;
        middle_off[i] = sample(p, Place<double>(at[i].x), Place<double>(at[i].y)).point - point[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 2) % 3;
        const ChordTriangle part{{t.at[i], at[i], at[k]},
                                 {t.point[i], point[i], point[k]},
                                 {t.off[i], middle_off[i], middle_off[k]}};
        if (!is_near(p, curvature, part, tolerance, halvings - 1)) return false;
    }
    return is_near(p, curvature, {at, point, middle_off}, tolerance, halvings - 1);
}

}  // namespace lancer::splines
