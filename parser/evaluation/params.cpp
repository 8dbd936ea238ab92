#include "parser/evaluation/params.h"

#include "parser/suggest.h"

namespace lancer {

Params::Params(const Context& context, const Definitions& definitions, Names& names)
    : context_(context), definitions_(definitions), names_(names) {
    Symbols& symbols = context.program.symbols;
    names.set_constant(symbols.intern("frame"), definitions.frame.value_or(0));
    names.set_constant(symbols.intern("time"), definitions.time.value_or(0));
}

void Params::define(const std::vector<std::pair<Symbol, Value>>& values) {
    Symbols& symbols = context_.program.symbols;
    // A param of the script that is called frame or time follows an animation like the built-in
    // constants.
    if (definitions_.frame) defined_[symbols.intern("frame")] = {Value(*definitions_.frame), true};
    if (definitions_.time) defined_[symbols.intern("time")] = {Value(*definitions_.time), true};
    for (const auto& [symbol, value] : values) {
        const std::string_view name = context_.text(symbol);
        const bool built_in = name == "frame" || name == "time";
        if (built_in && value.is_number()) names_.set_constant(symbol, value.number());
        defined_[symbol] = {value, built_in};
    }
}

const Value* Params::take(Symbol name) {
    params_.push_back(name);
    const auto given = defined_.find(name);
    if (given == defined_.end()) return nullptr;
    given->second.taken = true;
    return &given->second.value;
}

void Params::check(Report& usage) const {
    for (const auto& [name, source] : definitions_.values) {
        if (defined_.at(context_.program.symbols.intern(name)).taken) continue;
        Diagnostic* error = usage.error(Message::unknown_definition, SourceSpan{}, name);
        if (error == nullptr) continue;
        Suggestion suggestion(name);
        for (const Symbol param : params_) suggestion.consider(context_.text(param));
        error->hint = suggestion.hint();
    }
}

}  // namespace lancer
