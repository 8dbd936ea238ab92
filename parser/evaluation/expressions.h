// Evaluates expressions: postfix steps on a stack of values, so that deep scripts never need a deep
// stack of the program itself.
#pragma once

#include <cstdint>
#include <vector>

#include "parser/evaluation/computed_lists.h"
#include "parser/evaluation/function_calls.h"
#include "parser/evaluation/names.h"
#include "parser/evaluation/value_stack.h"

namespace lancer {

/// Makes the value of a material or texture that stands where a value does.
class InPlaceMaker {
  public:
    virtual Value make(const ast::File& file, std::uint32_t statement) = 0;

  protected:
    ~InPlaceMaker() = default;
};

class Expressions {
  public:
    Expressions(const Context& context, Names& names, Executed& executed, InPlaceMaker& in_place)
        : context_(context),
          names_(names),
          in_place_(in_place),
          lists_(context, names.scopes(), stack_),
          calls_(context, names, stack_, executed, lists_) {}

    /// The value of an expression; a broken value after an error, which was reported.
    Value evaluate(const ast::File& file, const ast::Expression& expression);

  private:
    void take(Run& run, const ast::Step& step);
    void take_condition(Run& run, const ast::Step& step);
    void take_operator(const ast::File& file, const ast::Step& step);
    void give_up(Run& run);
    const Value& literal(Symbol symbol);

    const Context context_;
    Names& names_;
    InPlaceMaker& in_place_;
    ValueStack stack_;
    ComputedLists lists_;
    FunctionCalls calls_;
    std::vector<Value> literals_;  ///< strings by symbol, so that each is made once
};

}  // namespace lancer
