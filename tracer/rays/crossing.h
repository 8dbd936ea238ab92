// Where a ray crosses a surface, and which crossings a query asks for.
#pragma once

#include <cstdint>
#include <limits>

#include "model/shapes.h"

namespace lancer {

/// One of the surfaces of a contact: which face of which primitive, crossed in which sense.
struct SurfaceId {
    std::uint32_t primitive = none;
    std::uint32_t face = 0;
    bool entering = false;  ///< against the outward normal

    bool operator==(const SurfaceId&) const = default;
};

/// What is known about a ray and a solid before their crossings are computed.
struct IntersectionHints {
    /// The ray starts on this face: its crossing there, at t = 0, is divided out, not computed.
    std::uint32_t start_face = none;
    /// The ray is inside the solid: it has a way out, even where rounding denies it.
    bool inside = false;
    /// The solid is one that can only be left from inside and only be entered from outside, so that
    /// other crossings need not be reported.
    bool one_way = false;

    bool asks_about(bool entering) const { return !one_way || entering != inside; }
};

/// A crossing of a ray with a surface, on the whole line: t may be negative.
template <class Real>
struct Crossing {
    Real t;
    Real error;  ///< bound on the rounding error of t
    std::uint32_t face;
    bool entering;  ///< against the outward normal; for sheets: against the front
    /// How far the ray then stays inside, where the solid is convex and its way out is known.
    Real chord = std::numeric_limits<Real>::infinity();
};

/// The interval of a line that a query asks about. What lies outside of it, before it by more than
/// its error, need not be reported, and needs no bound either: bounds cost as much as crossings.
///
/// \tparam Last  called without arguments: the parameter beyond which nothing matters. It may
///               shrink as crossings are reported. It may have a function accepts_estimate(): see
///               there
template <class Real, class Last>
struct RayInterval {
    Real first;
    const Last& last;

    /// Whether the query may do without the exact form of a crossing.
    static constexpr bool may_accept_estimates = requires(const Last& query, Real t) {
        query.accepts_estimate(t, t);
    };

    /// For shapes that know, from a filter, that a crossing which they would report lies between
    /// these parameters, with eight times its error bound on either side of it. True: the query
    /// wants to hear no more of the shape.
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
