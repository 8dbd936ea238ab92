// The operators of expressions.
#pragma once

#include "parser/ast.h"
#include "parser/meter.h"
#include "parser/report.h"
#include "parser/value.h"

namespace lancer {

/// The place of an operator or call, for its errors and its costs.
struct Site {
    Report& report;
    Meter& meter;
    SourceSpan place;
};

/// `a op b`, for the arithmetic operators and comparisons. A broken value after an error.
Value apply_binary(ast::Op op, const Value& a, const Value& b, const Site& site);
/// `-a` or `!a`.
Value apply_unary(ast::Op op, const Value& a, const Site& site);
/// How many elements a list has, or characters a string.
std::uint64_t size_of(const Value& value);
/// The same in words: "1 element", "3 characters".
std::string size_text(const Value& value);

/// The `count` characters from `from` on; the string must have them.
Value characters_of(const Value& text, std::uint64_t from, std::uint64_t count, const Site& site);

/// `list[index]`, also for strings and vectors.
Value element_at(const Value& list, const Value& index, const Site& site);
/// `v.x`, `v.y`, `v.z` for 0, 1, 2.
Value component_of(const Value& vector, unsigned component, const Site& site);

/// Compares numbers, bools, strings and lists. Values of different kinds are not equal.
bool equal_values(const Value& a, const Value& b, const Site& site);

/// x^y. For a whole number y it multiplies and carries the rounding errors along, so that 10^2 is
/// exactly 100; otherwise it calls elementary::pow.
double power(double x, double y);

/// Applies `number` to a number or to each component of a vector.
template <class F>
Value map_components(const Value& v, F number) {
    if (v.is_number()) return Value(number(v.number()));
    if (v.dimension() == 2) return {number(v.component(0)), number(v.component(1))};
    return {number(v.component(0)), number(v.component(1)), number(v.component(2))};
}

/// False for a number or vector that contains infinities or NaN; true for all other values.
bool is_finite_value(const Value& v);

}  // namespace lancer
