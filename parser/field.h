// Tables of fields: the names, values and meanings of a block's properties. One table per block
// drives reading, messages, suggestions and the list in docs/language.md.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/value.h"

namespace lancer {

/// Stands in place of a default when a property must be given.
inline constexpr std::string_view required = "required";

struct Field {
    std::string_view name;
    std::string_view takes;     ///< completes the sentence "'name' takes ..."
    std::string_view standard;  ///< the default, or `required`
    std::string_view doc;
    std::span<const std::string_view> words;  ///< the words that it takes, if any
    bool repeats = false;                     ///< may be given more than once
    /// Stores the value in the owner, a struct that the table was made for. Returns false when the
    /// value does not fit `takes`; `instead` may then describe the problem.
    bool (*read)(const Value& value, void* owner, std::string& instead) = nullptr;
};

template <class T>
struct member_of;
template <class Owner, class Type>
struct member_of<Type Owner::*> {
    using owner = Owner;
    using type = Type;
};

template <class Rule>
constexpr std::span<const std::string_view> words_of() {
    if constexpr (requires { Rule::words; }) {
        return Rule::words;
    } else {
        return {};
    }
}

/// A field that is stored in `Member`. A Rule (rules.h) describes and reads its value.
template <auto Member, class Rule>
constexpr Field field(std::string_view name, std::string_view standard, std::string_view doc) {
    using Owner = typename member_of<decltype(Member)>::owner;
    return {name,
            Rule::takes,
            standard,
            doc,
            words_of<Rule>(),
            false,
            [](const Value& value, void* owner, std::string& instead) {
                return Rule::read(value, static_cast<Owner*>(owner)->*Member, instead);
            }};
}

/// The same for a property that may be given more than once; each time adds to `Member`.
template <auto Member, class Rule>
constexpr Field repeated_field(std::string_view name, std::string_view doc) {
    Field result = field<Member, Rule>(name, "none", doc);
    result.repeats = true;
    return result;
}

/// A block: its own fields, and those that it shares with other blocks and stores in a second
/// struct.
struct BlockInfo {
    std::string_view keyword;
    std::string_view kind;  ///< the second word, of lights
    std::span<const Field> own;
    std::span<const Field> shared;
    std::string_view doc;
    bool holds_statements = false;

    /// "sphere", "point light".
    std::string title() const {
        return kind.empty() ? std::string(keyword) : std::string(kind) + " " + std::string(keyword);
    }
};

/// Every block of the language, in the order of the manual. `background` and `ambient` are
/// properties of the file; they are in a block without a keyword.
std::span<const BlockInfo> all_blocks();

}  // namespace lancer
