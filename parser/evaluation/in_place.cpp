#include "parser/evaluation/in_place.h"

#include "parser/evaluation/block_reader.h"

namespace lancer {

Value BlocksInPlace::make(const ast::File& file, std::uint32_t index) {
    const ast::Statement& statement = file.statements[index];
    const SourceSpan place = file.span(statement);
    // This is the only recursion of the evaluation: a function may hold a block, one of whose
    // properties calls the function.
    const std::uint64_t deepest = context_.meter.limits().nesting;
    if (depth_ >= deepest) {
        context_.report.error(Message::nesting_limit, place, deepest);
        throw StopReading{};
    }
    context_.meter.statement(place);
    executed_.mark(file, index);
    const Vocabulary& vocabulary = context_.vocabulary();
    const BlockWord& word = *vocabulary.block(statement.word, no_symbol);
    BlockReader reader(context_, file, statement, word);
    std::uint32_t result = none;
    ++depth_;
    maker_of (*word.info)(reader, result);
    --depth_;
    if (result == none) return {};
    return word.keyword == vocabulary.material ? Value::material(result) : Value::texture(result);
}

}  // namespace lancer
