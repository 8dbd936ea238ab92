// The builder's part for computed lists. Each `for` becomes an iteration: a step that opens it, the
// steps of the elements, and a step that goes back.
#include "parser/builder.h"

namespace lancer::grammar {

using ast::Op;

/// Emits a step whose place is a whole expression.
void Builder::emit_of(Op op, const ast::Expression& place) {
    const char* begin = text_.data() + place.offset;
    emit(op, begin, begin + place.length, 0);
}

void Builder::element() {
    Listed& listed = within_.counts.back();
    if (listed.gathers) {
        file_.steps.push_back({0, file_.steps.back().offset, file_.steps.back().length, Op::keep});
    } else {
        ++listed.count;
    }
}

void Builder::begin_computed(const char* at) {
    Listed& listed = within_.counts.back();
    if (!listed.gathers) emit(Op::gather, at, at, listed.count);
    listed.gathers = true;
    within_.computed.push_back(within_.clauses.size());
}

void Builder::each_word(const char* begin, const char* end) {
    Clause& clause = within_.clauses.emplace_back();
    clause.word = {0, offset_of(begin), static_cast<std::uint16_t>(end - begin), Op::again};
}

void Builder::each_variable(const char* begin, const char* end) {
    const Symbol name = symbols_.intern({begin, static_cast<std::size_t>(end - begin)});
    within_.clauses.back().variable = name;
    file_.variables.push_back(name);
}

void Builder::each_from() {
    emit_of(Op::bound, last_value_);
}

void Builder::each_range() {
    emit_of(Op::bound, last_value_);
    emit_each(Op::each_number, last_value_);
}

void Builder::each_list() {
    emit_each(Op::each_element, last_value_);
}

void Builder::emit_each(Op op, const ast::Expression& place) {
    within_.clauses.back().step = static_cast<std::uint32_t>(file_.steps.size());
    emit_of(op, place);
}

void Builder::only_if() {
    within_.clauses.push_back({{}, no_symbol, static_cast<std::uint32_t>(file_.steps.size())});
    emit_of(Op::only_if, last_value_);
}

void Builder::end_computed() {
    const ast::Step& last = file_.steps.back();
    file_.steps.push_back({0, last.offset, last.length, Op::keep});
    // From the innermost clause outwards. Conditions jump to the `again` of the `for` around them.
    std::size_t conditions = within_.clauses.size();
    for (std::size_t i = within_.clauses.size(); i-- > within_.computed.back();) {
        const Clause& clause = within_.clauses[i];
        if (clause.variable == no_symbol) continue;
        const auto here = static_cast<std::uint32_t>(file_.steps.size());
        for (std::size_t k = i + 1; k < conditions; ++k)
            file_.steps[within_.clauses[k].step].payload = here;
        conditions = i;
        file_.steps.push_back(clause.word);
        file_.steps.back().payload = clause.step + 1;
        const std::uint64_t after = file_.steps.size();
        file_.steps[clause.step].payload = clause.variable | after << 32;
    }
    within_.clauses.resize(within_.computed.back());
    within_.computed.pop_back();
}

}  // namespace lancer::grammar
