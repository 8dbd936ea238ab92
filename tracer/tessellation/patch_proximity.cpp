#include "tracer/tessellation/patch_proximity.h"

#include <algorithm>
#include <limits>

namespace lancer::splines {
namespace {

/// The largest number of halvings of a triangle's sides. Few parts need many: those whose distance
/// is nearly the tolerance, and those at folds.
constexpr int most_halvings = 10;
/// The number of parts after which the proof is given up.
constexpr int most_parts = 200;
/// The number of points tried for a foot. A foot that is not the nearest point may make a proof
/// fail, but never makes it wrong.
constexpr int foot_steps = 8;

/// The step to the nearest point if the patch were flat, in the free parameters (1 or 0 for each).
/// If the step would cross a border, it goes along the border.
Vec2d step_to_foot(const PatchSample<double>& s, const Vec3d& way, const Vec2d& at,
                   const Vec2d& free) {
    const double uu = length_squared(s.du);
    const double uv = dot(s.du, s.dv);
    const double vv = length_squared(s.dv);
    const double x = dot(s.du, way);
    const double y = dot(s.dv, way);
    const bool u_stays = free.x == 0 || uu == 0 || (at.x <= 0 && x < 0) || (at.x >= 1 && x > 0);
    const bool v_stays = free.y == 0 || vv == 0 || (at.y <= 0 && y < 0) || (at.y >= 1 && y > 0);
    const double det = uu * vv - uv * uv;
    if (!u_stays && !v_stays && det > 1e-8 * uu * vv)
        return {(vv * x - uv * y) / det, (uu * y - uv * x) / det};
    // If the slopes span no plane: the shortest of all steps to the nearest point.
    const double most = (u_stays ? 0 : uu) + (v_stays ? 0 : vv);
    return {u_stays ? 0 : x / most, v_stays ? 0 : y / most};
}

/// Whether the whole triangle lies in a ball of this radius about the foot of a corner.
bool is_around_a_foot(const std::array<FootPoint, 3>& t, double radius) {
    return std::ranges::any_of(t, [&](const FootPoint& corner) {
        const Vec3d foot = corner.point + corner.off;
        return std::ranges::all_of(
            t, [&](const FootPoint& other) { return length(other.point - foot) <= radius; });
    });
}

}  // namespace

FootPoint FootPoint::on(const Bicubic<double>& p, const Vec2d& at) {
    return {at, sample(p, Place<double>(at.x), Place<double>(at.y)).point, Vec3d(0)};
}

/// Gauss-Newton steps, which are shortened if the distance grows.
FootPoint NearPatch::with_foot(const Vec3d& point, const Vec2d& from, const Vec2d& free) const {
    FootPoint best{from, point, Vec3d(0)};
    double nearest = std::numeric_limits<double>::infinity();
    Vec2d step(0);
    for (int i = 0; i < foot_steps; ++i) {
        const Vec2d at(std::clamp(best.at.x + step.x, 0.0, 1.0),
                       std::clamp(best.at.y + step.y, 0.0, 1.0));
        const auto s = sample(points_, Place<double>(at.x), Place<double>(at.y));
        const Vec3d off = s.point - point;
        const double squared = length_squared(off);
        if (squared < nearest) {
            const bool is_settled = squared > 0.95 * nearest;
            best = {at, point, off};
            nearest = squared;
            if (is_settled) break;
            step = step_to_foot(s, -off, at, free);
        } else {
            step *= 0.25;
        }
    }
    return best;
}

/// The middle of two points, with its foot. The search starts between both feet, in both parameters
/// or in only one, as along a border; if that fails, it starts at each of the feet.
FootPoint NearPatch::middle(const FootPoint& a, const FootPoint& b) const {
    const Vec3d point = (a.point + b.point) / 2.0;
    const Vec2d between = (a.at + b.at) / 2.0;
    const Vec2d both(1);
    FootPoint found{};
    for (const auto& [from, free] : {std::pair(between, both),
                                     {between, Vec2d(1, 0)},
                                     {between, Vec2d(0, 1)},
                                     {a.at, both},
                                     {b.at, both}}) {
        found = with_foot(point, from, free);
        if (length(found.off) <= tolerance_) break;
    }
    return found;
}

NearPatch::Bends NearPatch::bends_over(const Vec2d& low, const Vec2d& high) const {
    return {low, high, curvature_.over(low.x, high.x, low.y, high.y).largest_lengths()};
}

bool NearPatch::holds(const std::array<FootPoint, 3>& triangle) const {
    const Bends none{Vec2d(1), Vec2d(0), {}};
    int parts = most_parts;
    return holds(triangle, none, most_halvings, parts);
}

bool NearPatch::holds(const std::array<FootPoint, 3>& t, const Bends& around, int halvings,
                      int& parts) const {
    double off = 0;
    for (const FootPoint& corner : t) off = std::max(off, length(corner.off));
    if (off > tolerance_) return false;
    const auto [u0, u1] = std::minmax({t[0].at.x, t[1].at.x, t[2].at.x});
    const auto [v0, v1] = std::minmax({t[0].at.y, t[1].at.y, t[2].at.y});
    // The bounds of the whole hold for a part. New bounds would take longer than a halving.
    const bool is_part =
        around.low.x <= u0 && u1 <= around.high.x && around.low.y <= v0 && v1 <= around.high.y;
    const Bends bends = is_part ? around : bends_over({u0, v0}, {u1, v1});
    if (off + chord_error(bends.most, u1 - u0, v1 - v0) <= tolerance_) return true;
    if (is_around_a_foot(t, tolerance_)) return true;
    if (halvings == 0 || --parts < 0) return false;
    const std::array<FootPoint, 3> m{middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
    return holds(m, bends, halvings - 1, parts) &&
           holds({t[0], m[0], m[2]}, bends, halvings - 1, parts) &&
           holds({m[0], t[1], m[1]}, bends, halvings - 1, parts) &&
           holds({m[2], m[1], t[2]}, bends, halvings - 1, parts);
}

}  // namespace lancer::splines
