// Finds all sign changes of a function of the spline parameter. None is missed, and none is
// reported without a sign change.
//
// The sign changes of Bernstein coefficients bound the number of roots in an interval. Intervals
// are halved until they contain none or one (Lane, Riesenfeld, "Bounds on a polynomial", BIT 21
// (1981)); the single root is found by Newton steps that never leave their bracket. Only signs
// decide: an interval with different signs at its ends has exactly one reported root, whatever
// rounding does inside, and adjacent intervals see the same sign at their common end. So the number
// of crossings along a closed curve is always even, which keeps closed surfaces tight.
#pragma once

#include <limits>
#include <utility>

#include "tracer/numerics/rounding.h"
#include "tracer/splines/bernstein.h"

namespace lancer::splines {

/// A sign change at `s`.
template <class Real>
struct Root {
    Real s;       ///< 0..1
    bool rising;  ///< from negative to positive
};

/// A polynomial, with the functions that sign_change_roots() needs.
template <class Real, std::size_t N>
struct Polynomial {
    Bernstein<Real, N> c;

    const Bernstein<Real, N>& coefficients() const { return c; }
    /// Bound on the rounding error of the coefficients.
    Real noise() const { return 0; }
    std::pair<Polynomial, Polynomial> split() const {
        const auto [left, right] = halves(c);
        return {{left}, {right}};
    }
    ValueAndSlope<Real> at(Real s) const {
        const auto [value, slope] = evaluate(c, s);
        return {value, slope};
    }
};

/// The root of `f` in [0, 1], where f has different signs at 0 and 1. Newton's method inside a
/// shrinking bracket (Press et al., Numerical Recipes, 3rd ed., section 9.4), to full precision.
template <class Real, class Function>
Real bracketed_root(const Function& f, bool rising) {
    using std::abs;
    Real low = 0;
    Real high = 1;
    Real s = Real(0.5);
    Real last_step = 1;
    for (int i = 0; i < 200; ++i) {
        const ValueAndSlope<Real> at = f.at(s);
        if (at.value == 0) return s;
        ((at.value < 0) == rising ? low : high) = s;
        Real next = s - at.value / at.slope;
        // Bisection replaces a step that leaves the bracket or is longer than half the step before.
        if (!(next > low && next < high) || abs(next - s) > abs(last_step) / 2) {
            next = low + (high - low) / 2;
        }
        last_step = next - s;
        if (!(abs(last_step) > 2 * unit_roundoff<Real> * s)) return next;
        s = next;
    }
    return s;
}

/// Calls found(Root) for every sign change of `f` over [low, high], in rising order. `f` offers
/// coefficients(), noise(), split() and at(), like Polynomial.
template <class Real, class Function, class Found>
void sign_change_roots(const Function& f, Real low, Real high, Found&& found) {
    const auto& c = f.coefficients();
    const int changes = sign_changes(c);
    if (changes == 0) return;
    const bool first_negative = c.front() < 0;
    const bool bracket = first_negative != (c.back() < 0);
    if (changes == 1) {
        found(Root<Real>{low + (high - low) * bracketed_root<Real>(f, first_negative),
                         first_negative});
        return;
    }
    // Halving ends if there is no number between the ends, or if all values are only rounding
    // errors.
    const Real middle = low + (high - low) / 2;
    bool undecidable = !(middle > low && middle < high);
    if (!undecidable) {
        const Real noise = f.noise();
        undecidable = true;
        for (const Real x : c) {
            if (x > noise || x < -noise) undecidable = false;
        }
    }
    if (undecidable) {
        if (bracket) found(Root<Real>{middle, first_negative});
        return;
    }
    const auto [left, right] = f.split();
    sign_change_roots(left, low, middle, found);
    sign_change_roots(right, middle, high, found);
}

template <class Real, class Function, class Found>
void sign_change_roots(const Function& f, Found&& found) {
    sign_change_roots(f, Real(0), Real(1), found);
}

}  // namespace lancer::splines
