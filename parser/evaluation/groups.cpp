#include "parser/evaluation/groups.h"

#include <optional>
#include <string>
#include <utility>

#include "parser/evaluation/block_reader.h"
#include "parser/evaluation/singles.h"
#include "parser/evaluation/unknown_words.h"

namespace lancer {

/// How a block of statements combines its bodies; nothing for a group.
static std::optional<Composite::Kind> joint_of(const Vocabulary& vocabulary, Symbol keyword) {
    if (keyword == vocabulary.unite) return Composite::Kind::unite;
    if (keyword == vocabulary.intersect) return Composite::Kind::intersect;
    if (keyword == vocabulary.subtract) return Composite::Kind::subtract;
    return std::nullopt;
}

Groups::Open Groups::open(const ast::File& file, const ast::Statement& statement,
                          const BlockWord& word) {
    if (file.name_of(statement) != no_symbol)
        context_.report.error(Message::block_takes_no_name, file.name_span(statement),
                              with_article(std::string(word.info->keyword)));
    context_.builder.open_group(file.span(statement),
                                joint_of(context_.vocabulary(), word.keyword));
    Group& group = groups_.emplace_back();
    group.keyword = word.keyword;
    group.given.resize(word.properties.fields().size());
    return std::exchange(open_, static_cast<Open>(groups_.size() - 1));
}

void Groups::close(Open outer) {
    context_.builder.close_group(groups_.back().attributes);
    groups_.pop_back();
    open_ = outer;
}

Groups::Open Groups::hide() {
    return std::exchange(open_, none);
}

/// All blocks of statements take the same properties.
const PropertySet& Groups::properties() const {
    const Vocabulary& vocabulary = context_.vocabulary();
    return vocabulary.block(vocabulary.group, no_symbol)->properties;
}

bool Groups::take_property(const ast::File& file, const ast::Statement& property) {
    if (open_ == none) return false;
    const std::uint8_t index = properties().index(property.word);
    if (index == PropertySet::unknown) return false;
    const Field& field = properties().field(index);
    Group& group = groups_[open_];
    const bool repeated =
        !field.repeats && is_repeated(context_.text(property.word), group.given[index],
                                      file.span(property), context_.report);
    if (!repeated) read_property(context_, file, property, field, &group.attributes);
    return true;
}

void Groups::take_material(const ast::File& file, const ast::Statement& material) {
    Group& group = groups_[open_];
    SourceSpan& first = group.given[properties().index(material.word)];
    if (is_repeated("material", first, file.span(material), context_.report)) return;
    group.attributes.material = make_inline_material(context_, file, material);
}

void Groups::report_unknown(const ast::File& file, const ast::Statement& property) const {
    const std::string title(context_.text(groups_[open_].keyword));
    report_unknown_property(file, property, properties(), title, context_);
}

}  // namespace lancer
