// All the places where a function of the spline parameter changes sign, none missed and none
// invented.
//
// Sign variations of Bernstein coefficients tell how many roots an interval can hold; intervals are
// halved until they hold none or one (Lane, Riesenfeld, "Bounds on a polynomial", BIT 21 (1981)),
// and the one is found by Newton steps that never leave their bracket. What decides are signs
// alone: an interval with different signs at its ends brings exactly one root, whatever rounding
// did inside, and neighbours see the same sign at their shared end. So the number of crossings
// along a closed curve is even always, which is what keeps closed surfaces tight.
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

/// A polynomial as a function whose roots are wanted.
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
/// shrinking bracket (Press et al., Numerical Recipes, 3rd ed., section 9.4), to the last digits.
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
        // A step out of the bracket, or not even half of the one before, is replaced by bisection.
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
    // Halving ends where the parameter has no number left in between, or the values are all
    // rounding.
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
