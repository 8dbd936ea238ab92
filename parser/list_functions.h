// The language's functions of lists, for the table in functions.cpp. Each is as Function::apply
// says.
#pragma once

#include <span>
#include <string_view>

#include "parser/operators.h"

namespace lancer {

Value concat_lists(std::string_view name, std::span<const Value> arguments, const Site& site);
Value reverse_list(std::string_view name, std::span<const Value> arguments, const Site& site);
/// Of strings, too.
Value slice(std::string_view name, std::span<const Value> arguments, const Site& site);
Value last_element(std::string_view name, std::span<const Value> arguments, const Site& site);
/// With the rounding errors added up beside the sum. Source: Neumaier, "Rundungsfehleranalyse
/// einiger Verfahren zur Summation endlicher Summen", ZAMM 54, 1974.
Value sum_list(std::string_view name, std::span<const Value> arguments, const Site& site);

}  // namespace lancer
