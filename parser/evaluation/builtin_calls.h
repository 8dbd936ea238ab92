// Calls of the language's own functions.
#pragma once

#include "parser/evaluation/context.h"
#include "parser/evaluation/value_stack.h"
#include "parser/functions.h"

namespace lancer {

/// What a function makes of the arguments on top of the stack, which stay there. After an error: a
/// broken value.
Value call_builtin(const Function& function, const ast::File& file, const ast::Step& call,
                   ValueStack& stack, const Context& context);

}  // namespace lancer
