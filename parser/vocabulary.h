// The words of the language as symbols: all blocks, and the properties of each.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "parser/field.h"
#include "parser/symbols.h"

namespace lancer {

struct Function;

/// The properties of one block by symbol.
class PropertySet {
  public:
    static constexpr std::uint8_t unknown = 0xFF;

    bool knows(Symbol word) const { return index(word) != unknown; }
    /// The index among the block's own fields, then the shared ones; `unknown` when there is none.
    std::uint8_t index(Symbol word) const { return word < index_.size() ? index_[word] : unknown; }
    const Field& field(std::uint8_t index) const { return *fields_[index]; }
    const std::vector<const Field*>& fields() const { return fields_; }
    void add(Symbol word, const Field& field);

  private:
    std::vector<std::uint8_t> index_;
    std::vector<const Field*> fields_;
};

struct BlockWord {
    const BlockInfo* info = nullptr;
    Symbol keyword = no_symbol;
    Symbol kind = no_symbol;
    PropertySet properties;
    std::size_t own_fields = 0;
};

class Vocabulary {
  public:
    explicit Vocabulary(Symbols& symbols);

    bool is_block(Symbol word) const { return word < is_block_.size() && is_block_[word]; }
    /// Whether the word is a group, union, intersection or difference: a block of statements.
    bool holds_statements(Symbol word) const {
        return word < holds_statements_.size() && holds_statements_[word];
    }
    /// The block with this keyword and, for a light, this kind; nullptr when there is none.
    const BlockWord* block(Symbol keyword, Symbol name) const;
    /// The properties that the grammar accepts inside a block; for an unknown block, any property.
    const PropertySet& properties(Symbol keyword, Symbol name) const;
    /// For files, groups and templates: the properties of a group, `background` and `ambient`.
    const PropertySet& in_statements() const { return in_statements_; }
    const BlockWord& file() const { return *file_; }
    /// Whether some block has a property of this name that takes one of a few words.
    bool takes_word(Symbol property) const {
        return any_.knows(property) && !any_.field(any_.index(property)).words.empty();
    }
    /// Whether some block has a property of this name.
    bool is_property(Symbol word) const { return any_.knows(word); }
    const std::vector<BlockWord>& blocks() const { return blocks_; }

    Symbol light, group, unite, intersect, subtract, material, texture;

  private:
    std::vector<BlockWord> blocks_;
    std::vector<bool> is_block_;
    std::vector<bool> holds_statements_;
    const BlockWord* file_ = nullptr;
    PropertySet in_statements_;
    PropertySet any_;
    PropertySet any_light_;
};

/// The language's own words. Their symbols are the same in every program.
struct LanguageWords {
    LanguageWords();

    Symbols symbols;
    Vocabulary vocabulary{symbols};
    std::vector<const Function*> functions;  ///< by symbol
};
const LanguageWords& language_words();

}  // namespace lancer
