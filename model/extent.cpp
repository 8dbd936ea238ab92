#include "model/extent.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lancer {
namespace {

/// The box of a disc perpendicular to `axis`.
Extent round_disc(const Vec3d& center, const Vec3d& axis, double radius) {
    const Vec3d a = axis / max_component(absolute(axis));
    const double whole = length(a);
    return around(center, Vec3d(std::hypot(a.y, a.z), std::hypot(a.z, a.x), std::hypot(a.x, a.y)) *
                              (radius / whole));
}

struct ExtentOf {
    Extent operator()(const Sphere& s) const { return around(s.center, Vec3d(s.radius)); }
    Extent operator()(const Box& b) const { return {b.min, b.max}; }
    Extent operator()(const Cylinder& c) const {
        return joined(round_disc(c.base, c.top - c.base, c.radius),
                      round_disc(c.top, c.top - c.base, c.radius));
    }
    Extent operator()(const Cone& c) const {
        return joined(round_disc(c.base, c.top - c.base, c.base_radius),
                      round_disc(c.top, c.top - c.base, c.top_radius));
    }
    Extent operator()(const Torus& t) const {
        const double r = t.radius + t.tube;
        return around(Vec3d(0), Vec3d(r, t.tube, r));
    }
    template <class Other>
    Extent operator()(const Other&) const {
        return {};
    }
};

/// The height of `p` on the axis from `base` to `top`, 0 to 1, and its distance from the axis.
std::pair<double, double> on_axis(const Vec3d& base, const Vec3d& top, const Vec3d& p) {
    const Vec3d axis = top - base;
    const double height = dot(p - base, axis) / dot(axis, axis);
    return {height, length(p - base - axis * height)};
}

struct Holds {
    const Vec3d& p;

    bool operator()(const Sphere& s) const { return length(p - s.center) <= s.radius; }
    bool operator()(const Box& b) const {
        for (int i = 0; i < 3; ++i)
            if (!(b.min[i] <= p[i] && p[i] <= b.max[i])) return false;
        return true;
    }
    bool operator()(const Plane& s) const {
        return dot(s.normal, p) <= s.offset * length(s.normal);
    }
    bool operator()(const Cylinder& c) const {
        const auto [height, distance] = on_axis(c.base, c.top, p);
        return 0 <= height && height <= 1 && distance <= c.radius;
    }
    bool operator()(const Cone& c) const {
        const auto [height, distance] = on_axis(c.base, c.top, p);
        return 0 <= height && height <= 1 &&
               distance <= c.base_radius + (c.top_radius - c.base_radius) * height;
    }
    template <class Other>
    bool operator()(const Other&) const {
        return false;
    }
};

}  // namespace

bool Extent::is_finite() const {
    return std::isfinite(dot(min, min) + dot(max, max));
}

bool Extent::is_inside_out() const {
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    for (int i = 0; i < 3; ++i)
        if (min[i] - max[i] > rounding * (std::abs(min[i]) + std::abs(max[i]))) return true;
    return false;
}

Extent around(const Vec3d& center, const Vec3d& half) {
    return {center - half, center + half};
}

Extent joined(const Extent& a, const Extent& b) {
    Extent both;
    for (int i = 0; i < 3; ++i) {
        both.min[i] = std::min(a.min[i], b.min[i]);
        both.max[i] = std::max(a.max[i], b.max[i]);
    }
    return both;
}

Extent common(const Extent& a, const Extent& b) {
    Extent both;
    for (int i = 0; i < 3; ++i) {
        both.min[i] = std::max(a.min[i], b.min[i]);
        both.max[i] = std::min(a.max[i], b.max[i]);
    }
    return both;
}

Extent shape_extent(const Shape& shape) {
    return std::visit(ExtentOf{}, shape);
}

bool convex_holds(const Shape& shape, const Vec3d& p) {
    return std::visit(Holds{p}, shape);
}

}  // namespace lancer
