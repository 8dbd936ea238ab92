// An expression that is being evaluated.
#pragma once

#include <cstddef>
#include <cstdint>

#include "parser/ast.h"
#include "parser/scopes.h"

namespace lancer {

/// One of a function of the script is a default of it, or what it stands for; what called it waits
/// (function_calls.h).
struct Run {
    const ast::File* file = nullptr;
    std::uint32_t at = 0, end = 0;             ///< the steps that are left
    std::size_t bottom = 0;                    ///< of its values on the stack
    const ast::Statement* function = nullptr;  ///< its parameters' places are below `bottom`
    std::uint32_t parameter = 0;               ///< the next to be bound
    Scopes::Caller caller;
    std::size_t iterations = 0, gathers = 0;  ///< below those that it opened
};

}  // namespace lancer
