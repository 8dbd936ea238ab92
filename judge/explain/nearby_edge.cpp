#include "judge/explain/nearby_edge.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/elementary.h"

namespace lancer::judge {

namespace {

constexpr int directions = 16;
/// The search circles as fractions of the radius. The smaller ones find features that are thinner
/// than the first.
constexpr std::array<double, 4> rings = {1.0, 0.1, 1e-3, 1e-6};

struct Point {
    double x, y;
};

Point between(const Point& a, const Point& b, double share) {
    return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
}

/// The two sides of a discontinuity, very close together.
struct Step {
    Point near_point;
    Point far_point;
    Probe near_side;
    Probe far_side;
};

/// Bisects between the centre and `end` for the place where our picture becomes nearer to `theirs`
/// than to its value at the centre.
Step close_in(const ProbeFunction& probe, const Point& centre, const Probe& at_centre,
              const Point& end, const Probe& at_end, const Color& theirs) {
    const double half = 0.5 * distance(at_centre.color, theirs);
    Step step{centre, end, at_centre, at_end};
    constexpr double hair = 1e-12;  // a few units in the last place of pixel coordinates
    while (std::hypot(step.far_point.x - step.near_point.x, step.far_point.y - step.near_point.y) >
           hair) {
        const Point middle = between(step.near_point, step.far_point, 0.5);
        // No floating-point number lies between the two.
        const bool stuck = (middle.x == step.near_point.x && middle.y == step.near_point.y) ||
                           (middle.x == step.far_point.x && middle.y == step.far_point.y);
        if (stuck) break;
        const Probe sample = probe(middle.x, middle.y);
        const bool beyond = distance(sample.color, theirs) < half;
        (beyond ? step.far_point : step.near_point) = middle;
        (beyond ? step.far_side : step.near_side) = sample;
    }
    return step;
}

/// True when our picture takes the value `theirs` at the far side of the step or further on towards
/// `end`. At a silhouette of a curved surface the value changes with the root of the distance, so
/// the samples are spaced geometrically.
bool reaches(const ProbeFunction& probe, const Step& step, const Point& end, const Color& theirs,
             double tolerance) {
    if (distance(step.far_side.color, theirs) <= tolerance) return true;
    for (double share = 1; share > 1e-12; share *= 0.5) {
        const Point p = between(step.far_point, end, share);
        if (distance(probe(p.x, p.y).color, theirs) <= tolerance) return true;
    }
    return false;
}

EdgeKind kind_of(const Step& step) {
    const Probe& a = step.near_side;
    const Probe& b = step.far_side;
    const bool depth_jumps =
        std::abs(a.depth - b.depth) > 1e-4 * std::max(std::abs(a.depth), std::abs(b.depth));
    if (a.object != b.object || depth_jumps || distance(a.normal, b.normal) > 1e-3) {
        return EdgeKind::silhouette;
    }
    if (a.lit != b.lit) return EdgeKind::shadow;
    return a.path != b.path ? EdgeKind::secondary : EdgeKind::texture;
}

/// The end points of the search. They avoid the axes, because exact edges often lie along them.
Point looked_at(const Point& centre, int direction, double radius) {
    const double angle = (direction + 0.37) * tau / directions;
    return {centre.x + radius * elementary::cos(angle), centre.y + radius * elementary::sin(angle)};
}

}  // namespace

std::optional<double> reached_at(const ProbeFunction& probe, double x, double y,
                                 const Color& theirs, double radius, double tolerance) {
    const Color ours = probe(x, y).color;
    const Color way = theirs - ours;
    // 0 at the centre, 1 where the value is reached.
    const auto share = [&](const Color& color) { return dot(color - ours, way) / dot(way, way); };
    std::optional<double> nearest;
    for (int i = 0; i < directions; ++i) {
        const auto color_at = [&](double far) {
            const Point p = looked_at({x, y}, i, far);
            return probe(p.x, p.y).color;
        };
        double before = 0;
        double beyond = std::ldexp(radius, -20);
        while (beyond <= radius && share(color_at(beyond)) < 1) {
            before = beyond;
            beyond *= 2;
        }
        if (beyond > radius) continue;
        for (int step = 0; step < 20; ++step) {
            const double middle = 0.5 * (before + beyond);
            (share(color_at(middle)) < 1 ? before : beyond) = middle;
        }
        if (distance(color_at(beyond), theirs) <= tolerance && (!nearest || beyond < *nearest))
            nearest = beyond;
    }
    return nearest;
}

std::optional<NearbyEdge> find_nearby_edge(const ProbeFunction& probe, double x, double y,
                                           const Color& theirs, double radius, double tolerance) {
    const Point centre{x, y};
    const Probe at_centre = probe(x, y);
    const double difference = distance(at_centre.color, theirs);
    std::optional<NearbyEdge> nearest;
    bool changes = false;
    for (const double ring : rings) {
        for (int i = 0; i < directions; ++i) {
            const Point end = looked_at(centre, i, radius * ring);
            const Probe at_end = probe(end.x, end.y);
            changes = changes || at_end.path != at_centre.path ||
                      distance(at_end.color, at_centre.color) > 0.1 * difference;
            if (distance(at_end.color, theirs) >= 0.5 * difference) continue;
            const Step step = close_in(probe, centre, at_centre, end, at_end, theirs);
            const double jump = distance(step.near_side.color, step.far_side.color);
            if (jump < 0.5 * difference) continue;  // a smooth change
            if (!reaches(probe, step, end, theirs, tolerance)) continue;
            const NearbyEdge found{kind_of(step), step.far_point.x - x, step.far_point.y - y, jump};
            if (!nearest || std::hypot(found.dx, found.dy) < std::hypot(nearest->dx, nearest->dy)) {
                nearest = found;
            }
        }
        if (nearest) break;
        // Nothing changes on the largest circle: a feature within it would be too small to matter.
        if (ring == rings.front() && !changes) break;
    }
    return nearest;
}

}  // namespace lancer::judge
