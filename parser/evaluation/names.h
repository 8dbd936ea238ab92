// The meaning of names while a script runs: first the script's own names, then the language's
// functions and constants. Reports names without a meaning.
#pragma once

#include <unordered_map>
#include <vector>

#include "parser/evaluation/context.h"
#include "parser/functions.h"
#include "parser/scopes.h"

namespace lancer {

class Names {
  public:
    explicit Names(const Context& context);

    Scopes& scopes() { return scopes_; }
    const Scopes& scopes() const { return scopes_; }

    void set_constant(Symbol name, double value) { constants_[name] = Value(value); }
    bool is_constant(Symbol name) const { return constants_.contains(name); }
    /// A function of the language; nullptr when there is none of this name.
    const Function* function(Symbol name) const {
        return name < functions_.size() ? functions_[name] : nullptr;
    }

    /// Whether a name, not called, has a value here.
    bool has_value(Symbol name) const { return scopes_.find(name) != nullptr || is_constant(name); }
    /// The value of a name in an expression; a broken value after an error. The reference is valid
    /// until the next name is bound.
    const Value& value_of(const ast::File& file, const ast::Step& step) const;

    /// Binds a name, which must be new in the innermost scope. False after an error.
    bool declare(Binding binding);
    /// Reports a name without a meaning and suggests a similar one. `functions`: the name is
    /// called.
    void report_undefined(Message message, const SourceSpan& place, Symbol name,
                          bool functions) const;

  private:
    SourceSpan place_of_definition(const SourceSpan& use, Symbol name) const;

    const Context context_;
    Scopes scopes_;
    const std::vector<const Function*>& functions_ = language_words().functions;
    std::unordered_map<Symbol, Value> constants_;
    const Value broken_;
};

}  // namespace lancer
