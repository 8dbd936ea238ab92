// Calls of the language's own functions.
#pragma once

#include "parser/evaluation/context.h"
#include "parser/evaluation/value_stack.h"
#include "parser/functions.h"

namespace lancer {

/// The result of a function for the arguments on top of the stack, which stay there. A broken value
/// after an error.
Value call_builtin(const Function& function, const ast::File& file, const ast::Step& call,
                   ValueStack& stack, const Context& context);

}  // namespace lancer
