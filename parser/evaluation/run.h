// An expression that is being evaluated.
#pragma once

#include <cstddef>
#include <cstdint>

#include "parser/ast.h"
#include "parser/scopes.h"

namespace lancer {

/// The run of a function of the script evaluates one of its defaults or its expression, while the
/// run of its caller waits (function_calls.h).
struct Run {
    const ast::File* file = nullptr;
    std::uint32_t at = 0, end = 0;  ///< the steps that remain
    std::size_t bottom = 0;         ///< the stack's size when the run began: its values are above
    const ast::Statement* function = nullptr;  ///< its arguments are below `bottom`
    std::uint32_t parameter = 0;               ///< the next parameter to bind
    Scopes::Caller caller;
    std::size_t iterations = 0, gathers = 0;  ///< how many were open when the run began
};

}  // namespace lancer
