// The language's functions of lists, for the table in functions.cpp. Function::apply describes the
// parameters.
#pragma once

#include <span>
#include <string_view>

#include "parser/operators.h"

namespace lancer {

Value concat_lists(std::string_view name, std::span<const Value> arguments, const Site& site);
Value reverse_list(std::string_view name, std::span<const Value> arguments, const Site& site);
/// Also for strings.
Value slice(std::string_view name, std::span<const Value> arguments, const Site& site);
Value last_element(std::string_view name, std::span<const Value> arguments, const Site& site);
/// Compensated summation. Source: Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation
/// endlicher Summen", ZAMM 54, 1974.
Value sum_list(std::string_view name, std::span<const Value> arguments, const Site& site);

}  // namespace lancer
