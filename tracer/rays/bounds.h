// Axis-aligned boxes that hold what they claim to hold, rounding included.
#pragma once

#include <limits>

#include "model/math.h"
#include "tracer/numerics/rounding.h"

namespace lancer {

/// Empty as constructed: every union and extension works on it.
template <class Real>
struct Bounds {
    Vec3<Real> min{std::numeric_limits<Real>::infinity()};
    Vec3<Real> max{-std::numeric_limits<Real>::infinity()};

    void extend(const Vec3<Real>& p) {
        for (int i = 0; i < 3; ++i) {
            if (p[i] < min[i]) min[i] = p[i];
            if (p[i] > max[i]) max[i] = p[i];
        }
    }
    void extend(const Bounds& b) {
        for (int i = 0; i < 3; ++i) {
            if (b.min[i] < min[i]) min[i] = b.min[i];
            if (b.max[i] > max[i]) max[i] = b.max[i];
        }
    }
    /// The largest size of a coordinate.
    Real reach() const {
        const Real low = max_component(absolute(min));
        const Real high = max_component(absolute(max));
        return low > high ? low : high;
    }
    bool contains(const Vec3<Real>& p) const {
        return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z &&
               p.z <= max.z;
    }
};

template <class Real>
bool is_empty(const Bounds<Real>& b) {
    return !(b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z);
}

/// Half the surface: what the surface-area heuristic compares.
template <class Real>
Real half_area(const Bounds<Real>& b) {
    const Vec3<Real> d = b.max - b.min;
    return d.x < 0 ? Real(0) : d.x * d.y + d.y * d.z + d.z * d.x;
}

/// Grown by a few roundings of its coordinates and of its size: the box of a computed surface then
/// holds the exact one, and a ray that starts on the surface is not shut out by a last bit.
template <class Real>
Bounds<Real> widened(Bounds<Real> b) {
    using std::abs;
    const Vec3<Real> size = b.max - b.min;
    const Real all = gamma<Real>(4) * max_component(size);
    for (int i = 0; i < 3; ++i) {
        const Real low = abs(b.min[i]);
        const Real high = abs(b.max[i]);
        const Real pad = gamma<Real>(4) * (low > high ? low : high) + all;
        b.min[i] -= pad;
        b.max[i] += pad;
    }
    return b;
}

/// Bounds of the sphere around `center` that is stretched to the half-axes in `reach`.
template <class Real>
Bounds<Real> around(const Vec3<Real>& center, const Vec3<Real>& reach) {
    Bounds<Real> b;
    b.extend(center - reach);
    b.extend(center + reach);
    return b;
}

}  // namespace lancer
