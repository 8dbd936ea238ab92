// Numbers and vectors. This is the only header that names GLM, and the only access to
// transcendental functions.
//
// Geometry and shading are templates over `Real`: float, double, long double, and in tests a
// 113-bit type. GLM's vector *types* compile for all of them, but its geometric *functions* do not.
// So the few that we need are here, each with a fixed order of operations: pictures must not depend
// on how a library sums.
#pragma once

#ifndef GLM_FORCE_XYZW_ONLY
#define GLM_FORCE_XYZW_ONLY
#endif
#ifndef GLM_FORCE_EXPLICIT_CTOR
#define GLM_FORCE_EXPLICIT_CTOR
#endif
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "model/elementary.h"

namespace lancer {

// std:: for the built-in types; argument-dependent lookup finds them for other types.
using std::frexp;
using std::ilogb;
using std::ldexp;
using std::signbit;

template <class Real>
using Vec2 = glm::vec<2, Real, glm::defaultp>;
template <class Real>
using Vec3 = glm::vec<3, Real, glm::defaultp>;

using Vec2d = Vec2<double>;
using Vec3d = Vec3<double>;
/// Linear RGB; scene-referred, not limited to 1.
using Color = Vec3<double>;

template <class Real>
constexpr Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
constexpr Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
constexpr Real length_squared(const Vec3<Real>& v) {
    return dot(v, v);
}

/// Euclidean length. It squares the components: |v| must be within the square root of the type's
/// range.
template <class Real>
Real length(const Vec3<Real>& v) {
    using std::sqrt;
    return sqrt(dot(v, v));
}

/// v / |v|. Not for the zero vector.
template <class Real>
Vec3<Real> normalize(const Vec3<Real>& v) {
    return v / length(v);
}

/// Whether a sum of squares is in the range in which neither it nor a significant term overflows or
/// underflows.
template <class Real>
constexpr bool is_sound_square(Real square) {
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    constexpr Real least = std::numeric_limits<Real>::min() / (epsilon * epsilon);
    return square > least && square < 1 / least;
}

template <class Real>
constexpr Real max_component(const Vec3<Real>& v) {
    const Real xy = v.x > v.y ? v.x : v.y;
    return xy > v.z ? xy : v.z;
}

/// Component by component absolute value.
template <class Real>
Vec3<Real> absolute(const Vec3<Real>& v) {
    using std::abs;
    return {abs(v.x), abs(v.y), abs(v.z)};
}

/// v / |v| for a vector of any length but 0. Returns v itself if its length is 1 up to its own
/// rounding.
template <class Real>
Vec3<Real> unit(const Vec3<Real>& v) {
    using std::abs;
    const Real square = length_squared(v);
    if (abs(square - 1) <= 4 * std::numeric_limits<Real>::epsilon()) return v;
    if (is_sound_square(square)) return normalize(v);
    return normalize(v / max_component(absolute(v)));
}

template <class Real>
bool is_finite(const Vec3<Real>& v) {
    using std::isfinite;
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

/// The same vector in another number type.
template <class To, class From>
Vec3<To> convert(const Vec3<From>& v) {
    return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.z)};
}

inline constexpr double pi = 3.141592653589793238462643383279502884;
inline constexpr double tau = 2.0 * pi;

constexpr double radians(double degrees) {
    return degrees * (pi / 180.0);
}
constexpr double degrees(double radians) {
    return radians * (180.0 / pi);
}

}  // namespace lancer
