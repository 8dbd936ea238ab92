#include "parser/evaluation/parameters.h"

#include "parser/suggest.h"

namespace lancer {

bool Parameters::give(Symbol name, Value value, std::vector<Given>& given, const SourceSpan& place,
                      const Context& context) const {
    std::size_t at = 0;
    while (at < size() && (*this)[at].name != name) ++at;
    if (at == size()) {
        report_unknown(name, place, context);
        return false;
    }
    if (given[at].is_given) {
        context.report.error(Message::argument_twice, place, context.text(name));
        return false;
    }
    given[at] = {std::move(value), true};
    return true;
}

void Parameters::report_unknown(Symbol name, const SourceSpan& place,
                                const Context& context) const {
    Diagnostic* error = context.report.error(Message::unknown_argument, place,
                                             context.text(this->name()), context.text(name));
    if (error == nullptr) return;
    Suggestion suggestion(context.text(name));
    for (std::size_t i = 0; i < size(); ++i) suggestion.consider(context.text((*this)[i].name));
    error->hint = suggestion.hint();
}

}  // namespace lancer
