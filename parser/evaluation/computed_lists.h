// Lists, including computed ones: [for i in 0..n if i != 3: f(i)]. The elements gather on the stack
// of values; open iterations have a stack of their own.
#pragma once

#include <cstddef>
#include <vector>

#include "parser/evaluation/context.h"
#include "parser/evaluation/iteration.h"
#include "parser/evaluation/run.h"
#include "parser/evaluation/value_stack.h"
#include "parser/scopes.h"

namespace lancer {

class ComputedLists {
  public:
    ComputedLists(const Context& context, Scopes& scopes, ValueStack& stack)
        : context_(context), scopes_(scopes), stack_(stack) {}

    /// A run of an expression whose stacks begin above all that is open.
    Run begin_run(const ast::File& file, const ast::Expression& expression) const;
    /// Executes one step of a computed list.
    void take(Run& run, const ast::Step& step);
    /// Closes what the run has opened.
    void give_up(const Run& run);
    /// Makes a list of the values from `first` on.
    void make_list(std::size_t first, const SourceSpan& place);

  private:
    void begin(Run& run, const ast::Step& step, Iteration iteration);
    void begin_range(Run& run, const ast::Step& step);
    void begin_elements(Run& run, const ast::Step& step);
    void go_on(Run& run, const ast::Step& step);
    void only_if(Run& run, const ast::Step& step);
    void end_iterations(std::size_t most);
    void check_held(const SourceSpan& place);

    const Context context_;
    Scopes& scopes_;
    ValueStack& stack_;
    std::vector<Iteration> iterations_;  ///< each has its variable in a scope of its own
    std::vector<std::size_t> gathers_;   ///< where on the stack the elements of each list begin
};

}  // namespace lancer
