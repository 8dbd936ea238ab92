#include "tracer/tessellation/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lancer::splines {
namespace {

/// The largest value of (x y a + y z b + z x c) / 2 over weights x, y, z >= 0 with the sum 1, for
/// a, b, c >= 0. For a triangle with the squared edges a, b, c it is half of the squared
/// circumradius; if the triangle is obtuse, half of the squared half of its longest edge.
double largest_mean(double a, double b, double c) {
    const double most = std::max({a, b, c});
    if (2 * most >= a + b + c) return most / 8;
    return a * b * c / (2 * (2 * (a * b + b * c + c * a) - (a * a + b * b + c * c)));
}

/// The values of the form uu du^2 + 2 uv du dv + vv dv^2 for the edges 0-1, 1-2, 2-0.
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

/// A bound on a coordinate of S - L, where the corners lie on S. For constant second derivatives it
/// is half of the sum, over all edges, of the product of both corners' weights times the second
/// derivative along the edge. The variation of the second derivatives is multiplied by the variance
/// of the corners' parameters, which is at most (width / 2)^2.
double Certificate::chord(const Second& second, const std::array<Vec2d, 3>& at) {
    const auto q = at_edges(second.uu.mid, second.uv.mid, second.vv.mid, at);
    const auto up = [](double x) { return std::max(x, 0.0); };
    const Vec2d e = extent(at);
    return std::max(largest_mean(up(q[0]), up(q[1]), up(q[2])),
                    largest_mean(up(-q[0]), up(-q[1]), up(-q[2]))) +
           (e.x * e.x * second.uu.radius + 2 * e.x * e.y * second.uv.radius +
            e.y * e.y * second.vv.radius) /
               8;
}

bool Certificate::find_shift(double along_a, double along_b, Shift& shift) const {
    // Bounds on the difference of the slopes, in the coordinates a and b, from the identity.
    const auto off = [&](const Second& s) {
        return std::array{s.uu.largest() * reach_u_ + s.uv.largest() * reach_v_,
                          s.uv.largest() * reach_u_ + s.vv.largest() * reach_v_};
    };
    const auto [au, av] = off(a_);
    const auto [bu, bv] = off(b_);
    // The smallest box that the fixed point map maps into itself: r = along + off r.
    const double det = (1 - au) * (1 - bv) - av * bu;
    if (!(au < 1 && bv < 1 && det > 0)) return false;
    shift.u = ((1 - bv) * along_a + av * along_b) / det;
    shift.v = ((1 - au) * along_b + bu * along_a) / det;
    return shift.u <= margin_u_ && shift.v <= margin_v_;
}

/// A bound on the change along N that the shift causes.
double Certificate::tilt(const Shift& shift) const {
    return (normal_.uu.largest() * reach_u_ + normal_.uv.largest() * reach_v_) * shift.u +
           (normal_.uv.largest() * reach_u_ + normal_.vv.largest() * reach_v_) * shift.v;
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

}  // namespace lancer::splines
