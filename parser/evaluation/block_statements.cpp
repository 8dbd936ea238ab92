#include "parser/evaluation/block_statements.h"

#include <string>

#include "parser/blocks/brightness.h"
#include "parser/evaluation/block_reader.h"
#include "parser/evaluation/singles.h"
#include "parser/evaluation/unknown_words.h"

namespace lancer {

void BlockStatements::read_property(const ast::File& file, const ast::Statement& statement) {
    const PropertySet& known = context_.vocabulary().file().properties;
    if (known.knows(statement.word)) {
        read_property_of_file(file, statement, known.field(known.index(statement.word)));
    } else if (groups_.take_property(file, statement)) {
        return;
    } else if (groups_.any()) {
        groups_.report_unknown(file, statement);
    } else {
        report_stray_property(file, statement, context_);
    }
}

void BlockStatements::read_property_of_file(const ast::File& file, const ast::Statement& statement,
                                            const Field& field) {
    const SourceSpan place = file.span(statement);
    const bool background = field.name == "background";
    if (background ? context_.singles.is_second_background(place)
                   : context_.singles.is_second_ambient(place))
        return;
    Scene& scene = context_.builder.scene;
    if (lancer::read_property(context_, file, statement, field, &scene))
        warn_bright_light(context_.report, file.span(statement.value),
                          background ? scene.background : scene.ambient);
}

const BlockWord* BlockStatements::read_block(const ast::File& file,
                                             const ast::Statement& statement) {
    const Vocabulary& vocabulary = context_.vocabulary();
    const BlockWord* word = vocabulary.block(statement.word, file.name_of(statement));
    if (word == nullptr) {
        report_unknown_block(file, statement, names_, context_);
        return nullptr;
    }
    if (word->info->holds_statements) return word;
    if (word->keyword == vocabulary.material && file.name_of(statement) == no_symbol &&
        groups_.any()) {
        groups_.take_material(file, statement);
    } else {
        make(file, statement, *word);
    }
    return nullptr;
}

void BlockStatements::make(const ast::File& file, const ast::Statement& statement,
                           const BlockWord& word) {
    const Vocabulary& vocabulary = context_.vocabulary();
    const bool material = word.keyword == vocabulary.material;
    const bool names_value = material || word.keyword == vocabulary.texture;
    const bool named = names_value || context_.text(word.keyword) == "camera";
    if (names_value && file.name_of(statement) == no_symbol)
        context_.report.error(Message::block_name_missing, file.span(statement),
                              word.info->keyword);
    if (!named && word.kind == no_symbol && file.name_of(statement) != no_symbol)
        context_.report.error(Message::block_takes_no_name, file.name_span(statement),
                              with_article(std::string(word.info->keyword)));
    BlockReader reader(context_, file, statement, word);
    std::uint32_t result = none;
    maker_of (*word.info)(reader, result);
    if (!names_value || file.name_of(statement) == no_symbol) return;
    Binding binding;
    binding.name = file.name_of(statement);
    binding.place = file.name_span(statement);
    if (result != none) binding.value = material ? Value::material(result) : Value::texture(result);
    names_.declare(std::move(binding));
}

}  // namespace lancer
