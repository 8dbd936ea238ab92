// The language's functions of vectors, for the table in functions.cpp. Each is as Function::apply
// says.
#pragma once

#include <span>
#include <string_view>

#include "parser/operators.h"

namespace lancer {

Value vector_length(std::string_view name, std::span<const Value> arguments, const Site& site);
Value normalize_vector(std::string_view name, std::span<const Value> arguments, const Site& site);
Value dot_product(std::string_view name, std::span<const Value> arguments, const Site& site);
Value cross_product(std::string_view name, std::span<const Value> arguments, const Site& site);

}  // namespace lancer
