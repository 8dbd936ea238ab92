// The language's own functions and constants.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "parser/operators.h"

namespace lancer {

struct Function {
    std::string_view name;
    std::size_t least, most;  ///< count of arguments
    std::string_view parameters;
    std::string_view doc;
    /// A broken value after an error, which was reported at the site. No argument may be broken.
    Value (*apply)(std::string_view name, std::span<const Value> arguments, const Site& site);
};

std::span<const Function> all_functions();

/// "1 argument", "2 or 3 arguments", "2 or more arguments": how many a call may have.
std::string arguments_text(std::size_t least, std::size_t most);
inline std::string arguments_text(std::size_t count) {
    return arguments_text(count, count);
}

struct Constant {
    std::string_view name;
    double value;
    std::string_view doc;
};
std::span<const Constant> all_constants();

}  // namespace lancer
