// Which methods of the tracer this set of kernels replaces by textbook formulas: LANCER_METHODS, a
// sum of the numbers below.
//
// The tracer's kernels are templates over the number type. What the files textbook_*.h declare for
// `double` alone is more special, so the tracer's own templates call it instead. Number type, tree,
// layout, shading and every line in between stay the same. Each set is a shared library of its own
// with hidden symbols, because all of them instantiate the same templates.
#pragma once

#include <concepts>

namespace lancer::methods {

/// The formulas of the five shapes, and what a ray prepares for them.
template <class Real>
concept Shapes = std::same_as<Real, double> &&(LANCER_METHODS & 1) != 0;
/// Slab tests that are not widened.
template <class Real>
concept Tree = std::same_as<Real, double> &&(LANCER_METHODS & 2) != 0;
/// Starts rounded to one number, lengths without scaling.
template <class Real>
concept Places = std::same_as<Real, double> &&(LANCER_METHODS & 4) != 0;
/// Only the nearest hit beyond an epsilon, without contacts.
template <class Real>
concept Contacts = std::same_as<Real, double> &&(LANCER_METHODS & 8) != 0;

}  // namespace lancer::methods
