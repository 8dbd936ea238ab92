#include "parser/evaluation/unknown_words.h"

#include "parser/habits.h"
#include "parser/suggest.h"

namespace lancer {

std::string with_article(const std::string& title) {
    const bool vowel = std::string_view("aeiou").find(title.front()) != std::string_view::npos &&
                       !title.starts_with("uni");
    return (vowel ? "an " : "a ") + title;
}

/// "center, radius, material, ...".
static std::string list_of(const PropertySet& properties) {
    std::string all;
    for (const Field* field : properties.fields())
        all.append(all.empty() ? "" : ", ").append(field->name);
    return all;
}

std::string_view report_unknown_property(const ast::File& file, const ast::Statement& property,
                                         const PropertySet& known, const std::string& title,
                                         const Context& context) {
    const std::string_view word = context.text(property.word);
    Diagnostic* error = context.report.error(Message::unknown_property, file.span(property), word,
                                             with_article(title));
    Suggestion suggestion(word);
    for (const Field* field : known.fields()) suggestion.consider(field->name);
    if (error != nullptr) {
        const Vocabulary& vocabulary = context.vocabulary();
        const bool of_material =
            known.knows(vocabulary.material) &&
            vocabulary.block(vocabulary.material, no_symbol)->properties.knows(property.word);
        const std::string_view instead = habits::instead_of(word);
        error->hint = !suggestion.empty() ? suggestion.hint()
                      : of_material
                          ? "'" + std::string(word) + "' is a property of materials: material { " +
                                std::string(word) + " ... }"
                      : instead.empty() ? with_article(title) + " has " + list_of(known)
                                        : std::string(instead);
    }
    for (const Field* field : known.fields())
        if (field->name == suggestion.word()) return field->name;
    return {};
}

void report_stray_property(const ast::File& file, const ast::Statement& property,
                           const Context& context) {
    const Vocabulary& vocabulary = context.vocabulary();
    const std::string_view word = context.text(property.word);
    const SourceSpan place = file.span(property);
    if (vocabulary.is_block(property.word)) {
        context.report.error(Message::property_is_block, place, word);
        return;
    }
    const bool known = vocabulary.is_property(property.word);
    Diagnostic* error = context.report.error(
        known ? Message::property_outside : Message::unknown_word, place, word);
    if (error == nullptr) return;
    Suggestion suggestion(word);
    for (const BlockWord& block : vocabulary.blocks()) suggestion.consider(block.info->keyword);
    for (const Field* field : vocabulary.file().properties.fields())
        suggestion.consider(field->name);
    for (const std::string_view reserved :
         {"include", "let", "param", "def", "func", "for", "if", "assert", "print"})
        suggestion.consider(reserved);
    const std::string_view instead = habits::instead_of(word);
    error->hint = instead.empty() ? suggestion.hint() : instead;
}

/// "image, render, camera, light, ...": every block, each keyword once.
static std::string list_of_blocks(const Vocabulary& vocabulary) {
    std::string all;
    std::string_view last;
    for (const BlockWord& block : vocabulary.blocks()) {
        const std::string_view keyword = block.info->keyword;
        if (keyword.empty() || keyword == last) continue;
        all += (all.empty() ? "" : ", ") + std::string(keyword);
        last = keyword;
    }
    return all;
}

void report_unknown_block(const ast::File& file, const ast::Statement& block, const Names& names,
                          const Context& context) {
    Report& report = context.report;
    const Vocabulary& vocabulary = context.vocabulary();
    const SourceSpan place = file.span(block);
    const bool light = block.word == vocabulary.light;
    if (light && file.name_of(block) == no_symbol) {
        report.error(Message::light_without_kind, place);
        return;
    }
    const Symbol wrong = light ? file.name_of(block) : block.word;
    const std::string word(context.text(wrong));
    Diagnostic* error = light ? report.error(Message::unknown_light, file.name_span(block), word)
                        : vocabulary.in_statements().knows(wrong)
                            ? report.error(Message::block_is_property, place, word)
                            : report.error(Message::unknown_block, place, word);
    if (error == nullptr) return;
    Suggestion suggestion(word);
    for (const BlockWord& known : vocabulary.blocks())
        if ((known.keyword == vocabulary.light) || !light)
            suggestion.consider(light ? known.info->kind : known.info->keyword);
    error->hint = suggestion.hint();
    if (names.scopes().find_callable(wrong) != nullptr) {
        error->hint = "write '" + word + "(...)' to call it";
    } else if (const std::string_view instead = habits::instead_of(word); !instead.empty()) {
        error->hint = instead;
    } else if (suggestion.empty()) {
        error->hint = light ? "use point, directional or spot"
                            : "the blocks are " + list_of_blocks(vocabulary);
    }
}

}  // namespace lancer
