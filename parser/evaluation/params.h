// The params of a script, and the values that -D gives them.
#pragma once

#include <unordered_map>
#include <utility>
#include <vector>

#include "parser/evaluation/context.h"
#include "parser/evaluation/names.h"

namespace lancer {

class Params {
  public:
    /// Defines `frame` and `time` as constants.
    Params(const Context& context, const Definitions& definitions, Names& names);

    /// Gives params these values, before the script runs.
    void define(const std::vector<std::pair<Symbol, Value>>& values);
    /// The value that a param of the script takes instead of its default; nullptr when there is
    /// none.
    const Value* take(Symbol name);
    /// Reports -D options that name no param. To be called after the script ran.
    void check(Report& usage) const;

  private:
    struct Defined {
        Value value;
        bool taken = false;  ///< a param uses it, or none needs to
    };

    const Context context_;
    const Definitions& definitions_;
    Names& names_;
    std::unordered_map<Symbol, Defined> defined_;
    std::vector<Symbol> params_;  ///< of the script
};

}  // namespace lancer
