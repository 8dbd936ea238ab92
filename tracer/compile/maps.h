// Maps into the world: which of them can be baked into a shape, and the frame for all others.
#pragma once

#include <cmath>
#include <initializer_list>

#include "tracer/rays/frame.h"

namespace lancer {

template <class Real>
bool is_identity(const Affine<Real>& map) {
    return map == Affine<Real>{};
}

/// Whether the linear part is a power of two times the identity. Such a map does not round.
template <class Real>
bool is_scale_by_two(const Affine<Real>& map) {
    using std::abs;
    int exponent = 0;
    const Real factor = map.rows[0].x;
    if (abs(frexp(factor, &exponent)) != Real(0.5)) return false;
    return map.rows[0] == Vec3<Real>(factor, 0, 0) && map.rows[1] == Vec3<Real>(0, factor, 0) &&
           map.rows[2] == Vec3<Real>(0, 0, factor);
}

/// The factor of a similarity, or 0 for any other map. A similarity has columns of equal lengths
/// and at right angles, up to rounding.
template <class Real>
Real similarity(const Affine<Real>& map) {
    using std::abs;
    using std::sqrt;
    const auto column = [&](int i) {
        return Vec3<Real>(map.rows[0][i], map.rows[1][i], map.rows[2][i]);
    };
    const Vec3<Real> x = column(0);
    const Vec3<Real> y = column(1);
    const Vec3<Real> z = column(2);
    const Real xx = dot(x, x);
    const Real bound = gamma<Real>(16) * xx;
    const bool even = abs(dot(y, y) - xx) <= bound && abs(dot(z, z) - xx) <= bound;
    const bool square =
        abs(dot(x, y)) <= bound && abs(dot(y, z)) <= bound && abs(dot(z, x)) <= bound;
    return even && square ? sqrt(xx) : Real(0);
}

/// The frame of an object that this map places in the world.
template <class Real>
Frame<Real> make_frame(const Affine<Real>& map) {
    const auto row_sum = [](const Affine<Real>& m) {
        Real most = 0;
        for (const Vec3<Real>& row : m.rows) {
            const Vec3<Real> a = absolute(row);
            const Real sum = a.x + a.y + a.z;
            if (sum > most) most = sum;
        }
        return most;
    };
    Frame<Real> frame;
    frame.to_world = map;
    Affine<Wide<Real>> linear = convert<Wide<Real>>(map);
    linear.shift = Vec3<Wide<Real>>(0);
    frame.linear_inverse = convert<Real>(inverse(linear));
    frame.linear_inverse.shift = Vec3<Real>(0);
    frame.norm = row_sum(map);
    frame.keeps_digits = is_scale_by_two(map);
    frame.transform_error = map.shift_error;
    frame.inverse_norm = row_sum(frame.linear_inverse);
    return frame;
}

/// How far rounding may have moved these points: as far as the map's own rounded numbers and the
/// operations on them allow, and what the last sum loses; not at all where digits are only moved. A
/// shift that changes no digit adds nothing.
template <class Real>
Real moved_by(const Affine<Real>& map, std::initializer_list<Vec3<Real>> points) {
    Real most = 0;
    for (const Vec3<Real>& p : points) {
        for (int i = 0; i < 3; ++i) {
            using std::abs;
            const Vec3<Real>& row = map.rows[static_cast<std::size_t>(i)];
            Real lost = abs(two_sum(map.shift[i], dot(row, p)).lo);
            if (!keeps_digits(row)) lost += gamma<Real>(8) * dot(absolute(row), absolute(p));
            if (lost > most) most = lost;
        }
    }
    return most + map.shift_error;
}

/// The same for lengths, which the map's shift does not move.
template <class Real>
Real resized_by(Affine<Real> map, Real length) {
    map.shift = Vec3<Real>(0);
    map.shift_error = 0;
    return moved_by(map, {Vec3<Real>(length)});
}

}  // namespace lancer
