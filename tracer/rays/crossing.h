// Crossings of a ray with a surface, and the crossings that a query needs.
#pragma once

#include <cstdint>
#include <limits>

#include "model/shapes.h"

namespace lancer {

/// A surface of a contact: a face of a primitive, and whether the ray enters there.
struct SurfaceId {
    std::uint32_t primitive = none;
    std::uint32_t face = 0;
    bool entering = false;  ///< the ray goes against the outward normal

    bool operator==(const SurfaceId&) const = default;
};

/// What is known of a ray and a solid before their crossings are computed.
struct IntersectionHints {
    /// The ray starts on this face. Its crossing there, at t = 0, is divided out and not computed.
    std::uint32_t start_face = none;
    /// The ray is inside the solid. So it has an exit, even if rounding hides it.
    bool inside = false;
    /// The state rule holds for the solid: if the ray is inside, only exits are needed, and if it
    /// is outside, only entries.
    bool one_way = false;

    bool asks_about(bool entering) const { return !one_way || entering != inside; }
};

/// A crossing of a ray with a surface, on the whole line: t may be negative.
template <class Real>
struct Crossing {
    Real t;
    Real error;  ///< bound on the rounding error of t
    std::uint32_t face;
    bool entering;  ///< the ray goes against the outward normal; for sheets: against the front
    /// The length that the ray then stays inside, if the exit is known.
    Real chord = std::numeric_limits<Real>::infinity();
};

/// The interval of a line that a query needs. Crossings beyond it, or before it by more than their
/// errors, need not be reported, and need no error bounds: bounds cost as much as crossings.
///
/// \tparam Last  last() returns the end of the interval, which may decrease as crossings are
///               reported. Last may have a function accepts_estimate(), see there
template <class Real, class Last>
struct RayInterval {
    Real first;
    const Last& last;

    /// Whether the query may accept an estimate in place of an exact crossing.
    static constexpr bool may_accept_estimates = requires(const Last& query, Real t) {
        query.accepts_estimate(t, t);
    };

    /// For shapes whose filter has found that a crossing which they would report lies in
    /// [low, high], with eight times its error bound on either side. If true, the query needs
    /// nothing else of the shape.
    bool accepts_estimate(Real low, Real high) const {
        if constexpr (may_accept_estimates) return last.accepts_estimate(low, high);
        return false;
    }

    bool ends_before(Real t) const { return t > last(); }
    bool holds(const Crossing<Real>& c) const { return c.t + c.error >= first; }
};

/// The whole line.
template <class Real>
inline constexpr auto endless = [] { return std::numeric_limits<Real>::infinity(); };
template <class Real>
RayInterval<Real, decltype(endless<Real>)> whole_line() {
    return {-std::numeric_limits<Real>::infinity(), endless<Real>};
}

}  // namespace lancer
