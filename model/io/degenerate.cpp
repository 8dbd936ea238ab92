#include "model/io/degenerate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lancer::io {
namespace {

/// v scaled by a power of two to a largest component in [1, 2); zero stays zero.
inline Vec3d scaled_to_one(const Vec3d& v) {
    const double size = max_component(absolute(v));
    return size > 0 ? scaled_by_power_of_two(v, -std::ilogb(size)) : v;
}

}  // namespace

// The angle is taken at the corner opposite to the longest edge, so a needle with a right angle is
// a triangle however thin it is. Let u = 2^-53. The components of the two edges e, f at this corner
// have an error of at most u; a product of two has an error of at most 3 u; the rounding of the
// difference of products is negligible where the difference is near 0. So the error of each
// component of the cross product is at most 3 u (|e_i f_j| + |e_j f_i|), and that of its length at
// most 3 sqrt(2) u |e| |f|.
bool is_degenerate(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    if (a == b || b == c || c == a) return true;
    // Coordinates are halved, so that the difference of two finite numbers cannot overflow.
    const auto edge = [](const Vec3d& from, const Vec3d& to) {
        return Vec3d(to * 0.5 - from * 0.5);
    };
    Vec3d e = edge(b, a);
    Vec3d f = edge(b, c);
    const Vec3d g = edge(a, c);
    const double largest = std::max(
        {max_component(absolute(e)), max_component(absolute(f)), max_component(absolute(g))});
    if (!(largest > 0)) return true;  // halving the smallest number gives 0
    const auto size = [&](const Vec3d& v) {
        return length_squared(scaled_by_power_of_two(v, -std::ilogb(largest)));
    };
    const double ee = size(e), ff = size(f), gg = size(g);
    if (gg < ee || gg < ff) (ee > ff ? e : f) = g;  // b is not opposite to the longest edge
    e = scaled_to_one(e);
    f = scaled_to_one(f);
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    const double bound = 4.5 * u;  // 3 sqrt(2) = 4.24, and a margin for the terms in u^2
    return length_squared(cross(e, f)) <= bound * bound * length_squared(e) * length_squared(f);
}

}  // namespace lancer::io
