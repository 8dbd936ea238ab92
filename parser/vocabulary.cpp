#include "parser/vocabulary.h"

#include "parser/functions.h"

namespace lancer {

void PropertySet::add(Symbol word, const Field& field) {
    if (knows(word)) return;
    if (index_.size() <= word) index_.resize(word + 1, unknown);
    index_[word] = static_cast<std::uint8_t>(fields_.size());
    fields_.push_back(&field);
}

Vocabulary::Vocabulary(Symbols& symbols)
    : light(symbols.intern("light")),
      group(symbols.intern("group")),
      unite(symbols.intern("union")),
      intersect(symbols.intern("intersection")),
      subtract(symbols.intern("difference")),
      material(symbols.intern("material")),
      texture(symbols.intern("texture")) {
    for (const BlockInfo& info : all_blocks()) {
        BlockWord& block = blocks_.emplace_back();
        block.info = &info;
        block.own_fields = info.own.size();
        if (!info.keyword.empty()) {
            block.keyword = symbols.intern(info.keyword);
            if (is_block_.size() <= block.keyword) is_block_.resize(block.keyword + 1);
            is_block_[block.keyword] = true;
            holds_statements_.resize(is_block_.size());
            holds_statements_[block.keyword] = info.holds_statements;
        }
        if (!info.kind.empty()) block.kind = symbols.intern(info.kind);
        for (const auto& part : {info.own, info.shared}) {
            for (const Field& field : part) {
                const Symbol word = symbols.intern(field.name);
                block.properties.add(word, field);
                any_.add(word, field);
                if (block.keyword == light) any_light_.add(word, field);
                if (info.holds_statements || info.keyword.empty()) in_statements_.add(word, field);
            }
        }
    }
    for (const BlockWord& block : blocks_)
        if (block.info->keyword.empty()) file_ = &block;
}

const BlockWord* Vocabulary::block(Symbol keyword, Symbol name) const {
    if (!is_block(keyword)) return nullptr;
    for (const BlockWord& block : blocks_)
        if (block.keyword == keyword && (block.kind == no_symbol || block.kind == name))
            return &block;
    return nullptr;
}

const PropertySet& Vocabulary::properties(Symbol keyword, Symbol name) const {
    if (holds_statements(keyword)) return in_statements_;
    if (const BlockWord* found = block(keyword, name)) return found->properties;
    return keyword == light ? any_light_ : any_;
}

LanguageWords::LanguageWords() {
    for (const Function& function : all_functions()) {
        const Symbol symbol = symbols.intern(function.name);
        if (functions.size() <= symbol) functions.resize(symbol + 1, nullptr);
        functions[symbol] = &function;
    }
    for (const Constant& constant : all_constants()) symbols.intern(constant.name);
}

const LanguageWords& language_words() {
    static const LanguageWords words;  // making it takes a third of the time for a small script
    return words;
}

}  // namespace lancer
