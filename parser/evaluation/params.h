// The params of a script, and what -D says of them.
#pragma once

#include <unordered_map>
#include <utility>
#include <vector>

#include "parser/evaluation/context.h"
#include "parser/evaluation/names.h"

namespace lancer {

class Params {
  public:
    /// `frame` and `time` become constants.
    Params(const Context& context, const Definitions& definitions, Names& names);

    /// Gives params these values, before the script runs.
    void define(const std::vector<std::pair<Symbol, Value>>& values);
    /// A param of the script: what it has instead of its default; nullptr: nothing.
    const Value* take(Symbol name);
    /// Reports what -D said wrong: names that no param has. After the script ran.
    void check(Report& usage) const;

  private:
    struct Defined {
        Value value;
        bool taken = false;  ///< a param has it, or may do without
    };

    const Context context_;
    const Definitions& definitions_;
    Names& names_;
    std::unordered_map<Symbol, Defined> defined_;
    std::vector<Symbol> params_;  ///< of the script
};

}  // namespace lancer
