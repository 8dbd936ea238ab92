// Runs the statements that are blocks or properties: what stands in files, groups and templates.
#include <optional>

#include "parser/block_reader.h"
#include "parser/blocks/brightness.h"
#include "parser/evaluator.h"
#include "parser/habits.h"
#include "parser/suggest.h"

namespace lancer {

void Evaluator::execute_property(const ast::File& file, const ast::Statement& statement) {
    const Vocabulary& vocabulary = program_.vocabulary;
    const std::string_view word = text(statement.word);
    if (const PropertySet& known = vocabulary.file().properties; known.knows(statement.word)) {
        const Field& field = known.field(known.index(statement.word));
        SourceSpan& first = word == "background" ? background_place : ambient_place;
        if (is_repeated(word, first, file.span(statement))) return;
        if (word == "background") check_one_background(file.span(statement));
        if (BlockReader::read_property(*this, file, statement, field, &builder_.scene))
            warn_bright_light(
                report_, file.span(statement.value),
                word == "background" ? builder_.scene.background : builder_.scene.ambient);
        return;
    }
    const BlockWord& group = *vocabulary.block(vocabulary.group, no_symbol);
    const std::uint8_t index = group.properties.index(statement.word);
    if (group_ != none && index != PropertySet::unknown) {
        const Field& field = group.properties.field(index);
        Group& open = groups_[group_];
        if (!field.repeats && is_repeated(word, open.given[index], file.span(statement))) return;
        BlockReader::read_property(*this, file, statement, field, &open.attributes);
        return;
    }
    if (group_ != none) {
        BlockReader::report_unknown(*this, file, statement, group.properties,
                                    std::string(text(groups_[group_].keyword)));
    } else if (vocabulary.is_block(statement.word)) {
        report_.error(Message::property_is_block, file.span(statement), word);
    } else {
        const bool known = vocabulary.is_property(statement.word);
        Diagnostic* error = report_.error(known ? Message::property_outside : Message::unknown_word,
                                          file.span(statement), word);
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
}

/// "image, render, camera, light, ...", each once.
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

void Evaluator::report_unknown_block(const ast::File& file, const ast::Statement& statement) {
    const Vocabulary& vocabulary = program_.vocabulary;
    const SourceSpan place = file.span(statement);
    const bool light = statement.word == vocabulary.light;
    if (light && statement.name == no_symbol) {
        report_.error(Message::light_without_kind, place);
        return;
    }
    const Symbol wrong = light ? statement.name : statement.word;
    Diagnostic* error =
        light ? report_.error(Message::unknown_light, file.name_span(statement), text(wrong))
        : vocabulary.in_statements().knows(wrong)
            ? report_.error(Message::block_is_property, place, text(wrong))
            : report_.error(Message::unknown_block, place, text(wrong));
    if (error == nullptr) return;
    Suggestion suggestion(text(wrong));
    for (const BlockWord& block : vocabulary.blocks())
        if ((block.keyword == vocabulary.light) || !light)
            suggestion.consider(light ? block.info->kind : block.info->keyword);
    error->hint = suggestion.hint();
    if (scopes_.find_callable(wrong) != nullptr) {
        error->hint =
            "'" + std::string(text(wrong)) + "' is called: " + std::string(text(wrong)) + "(...)";
    } else if (const std::string_view instead = habits::instead_of(text(wrong)); !instead.empty()) {
        error->hint = instead;
    } else if (suggestion.empty()) {
        error->hint = light ? "lights are point, directional and spot"
                            : "the blocks are " + list_of_blocks(vocabulary);
    }
}

/// What a block of statements makes of the bodies in it; nothing for a group.
static std::optional<Composite::Kind> joint_of(const Vocabulary& vocabulary, Symbol keyword) {
    if (keyword == vocabulary.unite) return Composite::Kind::unite;
    if (keyword == vocabulary.intersect) return Composite::Kind::intersect;
    if (keyword == vocabulary.subtract) return Composite::Kind::subtract;
    return std::nullopt;
}

void Evaluator::execute_block(const ast::File& file, const ast::Statement& statement) {
    const Vocabulary& vocabulary = program_.vocabulary;
    const SourceSpan place = file.span(statement);
    const BlockWord* word = vocabulary.block(statement.word, statement.name);
    if (word == nullptr) {
        report_unknown_block(file, statement);
        return;
    }
    if (word->info->holds_statements) {
        if (statement.name != no_symbol)
            report_.error(Message::block_takes_no_name, file.name_span(statement),
                          with_article(std::string(word->info->keyword)));
        builder_.open_group(place, joint_of(vocabulary, word->keyword));
        Group& group = groups_.emplace_back();
        group.keyword = word->keyword;
        group.given.resize(word->properties.fields().size());
        Frame& frame = push(Frame::Kind::group, file, statement.body);
        frame.outer_group = group_;
        group_ = static_cast<std::uint32_t>(groups_.size() - 1);
        scopes_.open();
        return;
    }
    const bool names_value =
        word->keyword == vocabulary.material || word->keyword == vocabulary.texture;
    if (word->keyword == vocabulary.material && statement.name == no_symbol && group_ != none) {
        const std::uint8_t index =
            vocabulary.block(vocabulary.group, no_symbol)->properties.index(statement.word);
        Group& open = groups_[group_];
        if (is_repeated("material", open.given[index], place)) return;
        open.attributes.material = make_inline_material(file, statement);
        return;
    }
    const bool named = names_value || text(word->keyword) == "camera";
    if (names_value && statement.name == no_symbol)
        report_.error(Message::block_name_missing, place, word->info->keyword);
    if (!named && word->kind == no_symbol && statement.name != no_symbol)
        report_.error(Message::block_takes_no_name, file.name_span(statement),
                      with_article(std::string(word->info->keyword)));
    BlockReader reader(*this, file, statement, *word);
    std::uint32_t result = none;
    maker_of (*word->info)(reader, result);
    if (!names_value || statement.name == no_symbol) return;
    Binding binding;
    binding.name = statement.name;
    binding.place = file.name_span(statement);
    if (result != none)
        binding.value =
            word->keyword == vocabulary.material ? Value::material(result) : Value::texture(result);
    declare(std::move(binding));
}

std::uint32_t Evaluator::make_inline_material(const ast::File& file,
                                              const ast::Statement& statement) {
    const BlockWord& word = *program_.vocabulary.block(program_.vocabulary.material, no_symbol);
    if (statement.name != no_symbol)
        report_.error(Message::block_takes_no_name, file.name_span(statement),
                      "a material inside a shape");
    BlockReader reader(*this, file, statement, word);
    std::uint32_t result = none;
    maker_of (*word.info)(reader, result);
    return result;
}

Value Evaluator::block_in_place(const ast::File& file, std::uint32_t index) {
    const ast::Statement& statement = file.statements[index];
    const SourceSpan place = file.span(statement);
    // The one recursion of the evaluator: a function may hold a block whose property calls it.
    if (in_place_ >= meter_.limits().nesting) {
        report_.error(Message::nesting_limit, place, meter_.limits().nesting);
        throw StopReading{};
    }
    meter_.statement(place);
    mark_executed(file, index);
    const BlockWord& word = *program_.vocabulary.block(statement.word, no_symbol);
    BlockReader reader(*this, file, statement, word);
    std::uint32_t result = none;
    ++in_place_;
    maker_of (*word.info)(reader, result);
    --in_place_;
    if (result == none) return {};
    return word.keyword == program_.vocabulary.material ? Value::material(result)
                                                        : Value::texture(result);
}

void Evaluator::check_one_background(const SourceSpan& place) {
    const bool both =
        background_place.file != SourceSpan::nowhere && sky_place.file != SourceSpan::nowhere;
    if (!both) return;
    Diagnostic* error = report_.error(Message::sky_and_background, place);
    const bool sky_is_first =
        background_place.offset == place.offset && background_place.file == place.file;
    if (error != nullptr)
        error->notes.insert(
            error->notes.begin(),
            Report::note(Message::first_here, sky_is_first ? sky_place : background_place));
}

bool Evaluator::is_repeated(std::string_view word, SourceSpan& first, const SourceSpan& place) {
    if (first.file == SourceSpan::nowhere) {
        first = place;
        return false;
    }
    Diagnostic* error = report_.error(Message::given_twice, place, word);
    if (error != nullptr)
        error->notes.insert(error->notes.begin(), Report::note(Message::first_here, first));
    return true;
}

}  // namespace lancer
