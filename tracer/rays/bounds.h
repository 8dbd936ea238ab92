// Axis-aligned bounding boxes that are conservative under rounding.
#pragma once

#include <limits>

#include "model/math.h"
#include "tracer/numerics/rounding.h"

namespace lancer {

/// A box is empty at first. It can then be extended.
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
    /// The largest absolute coordinate.
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

/// Half the surface area, as the surface-area heuristic compares it.
template <class Real>
Real half_area(const Bounds<Real>& b) {
    const Vec3<Real> d = b.max - b.min;
    return d.x < 0 ? Real(0) : d.x * d.y + d.y * d.z + d.z * d.x;
}

/// The box enlarged by a few rounding errors of its coordinates and of its size. So the box of a
/// computed surface contains the exact one, and a ray that starts on the surface meets the box.
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

/// The box with this centre and these half extents.
template <class Real>
Bounds<Real> around(const Vec3<Real>& center, const Vec3<Real>& reach) {
    Bounds<Real> b;
    b.extend(center - reach);
    b.extend(center + reach);
    return b;
}

}  // namespace lancer
