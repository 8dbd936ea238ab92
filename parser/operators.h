// What the operators do with values.
#pragma once

#include "parser/ast.h"
#include "parser/meter.h"
#include "parser/report.h"
#include "parser/value.h"

namespace lancer {

/// Where an operator or function is at work, for its errors and costs.
struct Site {
    Report& report;
    Meter& meter;
    SourceSpan place;
};

/// `a op b`, for the arithmetic operators and comparisons. After an error: a broken value.
Value apply_binary(ast::Op op, const Value& a, const Value& b, const Site& site);
/// `-a` or `!a`.
Value apply_unary(ast::Op op, const Value& a, const Site& site);
/// `list[index]`.
/// How many elements a list has, or characters a string.
std::uint64_t size_of(const Value& value);
/// The same in words: "1 element", "3 characters".
std::string size_text(const Value& value);

/// Characters of a string that has them.
Value characters_of(const Value& text, std::uint64_t from, std::uint64_t count, const Site& site);

Value element_at(const Value& list, const Value& index, const Site& site);
/// `v.x`, `v.y`, `v.z` for 0, 1, 2.
Value component_of(const Value& vector, unsigned component, const Site& site);

/// Equal numbers, bools, strings, lists; values of different kinds are not equal.
bool equal_values(const Value& a, const Value& b, const Site& site);

/// x^y. An exponent that is a whole number is done by multiplication, with the rounding errors
/// carried along, so that 10^2 is 100; others by elementary::pow.
double power(double x, double y);

/// Component by component: `number(x)` for a number, for each component of a vector.
template <class F>
Value map_components(const Value& v, F number) {
    if (v.is_number()) return Value(number(v.number()));
    if (v.dimension() == 2) return {number(v.component(0)), number(v.component(1))};
    return {number(v.component(0)), number(v.component(1)), number(v.component(2))};
}

/// True for numbers and vectors without infinities or NaN, and for all that is neither.
bool is_finite_value(const Value& v);

}  // namespace lancer
