// Calls of functions in expressions. The evaluation loop itself continues in a function of the
// script, so nested calls do not deepen the stack of the program.
#pragma once

#include <cstddef>
#include <vector>

#include "parser/evaluation/computed_lists.h"
#include "parser/evaluation/executed.h"
#include "parser/evaluation/names.h"
#include "parser/evaluation/parameters.h"
#include "parser/evaluation/run.h"
#include "parser/evaluation/value_stack.h"

namespace lancer {

class FunctionCalls {
  public:
    FunctionCalls(const Context& context, Names& names, ValueStack& stack, Executed& executed,
                  const ComputedLists& lists)
        : context_(context), names_(names), stack_(stack), executed_(executed), lists_(lists) {}

    /// Replaces the arguments by the result. For a function of the script, `run` becomes the run of
    /// its body.
    void call(Run& run, const ast::Step& step);
    /// At the end of a function's run: goes on with its next default, or in the caller with the
    /// result.
    void end(Run& run, Value result);

  private:
    void enter(Run& run, const ast::Step& call, const Binding& callee);
    bool arrange(const Run& run, const ast::Step& call, const Parameters& parameters);
    bool arrange_named(const Run& run, std::size_t first, std::size_t unnamed,
                       const Parameters& parameters);
    void bind_parameters(Run& run);
    void report_no_function(Symbol name, const SourceSpan& place, const Binding* binding);

    const Context context_;
    Names& names_;
    ValueStack& stack_;
    Executed& executed_;
    const ComputedLists& lists_;
    std::vector<Run> waiting_;  ///< callers of the functions that run
};

}  // namespace lancer
