// What a script says, before names have a meaning: statements with their places, expressions as
// flat lists of steps. The tree is generic: it knows no shape, light or material.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/source.h"
#include "parser/symbols.h"

namespace lancer::ast {

/// Steps of an expression in postfix order, so that reading, evaluating and destroying a long one
/// need no recursion. Each step takes its operands from a stack and leaves its result there.
enum class Op : std::uint8_t {
    number,  ///< payload: the value's bits
    text,    ///< payload: a symbol
    yes,     ///< true
    no,      ///< false
    color,   ///< payload: 0xrrggbb
    name,    ///< payload: a symbol
    call,    ///< payload: a symbol and the count of arguments
    named,   ///< marks the value before it as a named argument; payload: a symbol
    list,    ///< payload: the count of elements
    index,   ///< list, index -> element
    member,  ///< payload: 0, 1, 2 for x, y, z
    negate,
    invert,
    add,
    subtract,
    multiply,
    divide,
    modulo,
    power,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    not_equal,
    // Jumps: payload is the index of the step to go on with.
    and_then,  ///< left side false: leave it and jump past `and_end`
    and_end,
    or_else,  ///< left side true: leave it and jump past `or_end`
    or_end,
    choose,  ///< condition false: jump to the third operand
    jump,    ///< after the second operand: jump past the third
    skip,    ///< jump over the steps of the block in place that comes next
    block,   ///< a material or texture in place; payload: index into File::statements
    // Computed lists: the elements gather on the stack.
    gather,        ///< payload: the count of elements before the first computed one
    bound,         ///< reports a bound that is not a whole number
    each_number,   ///< from, to -> an iteration; payload: the variable, and the step after its end
    each_element,  ///< list -> an iteration; the same payload
    only_if,       ///< condition false: jump
    keep,          ///< counts an element of the list
    again,         ///< the variable's next value: jump back; after the last: end of the iteration
    gathered,      ///< the elements since `gather` -> list
};

/// The length of a token, as far as it is kept: messages show no longer ones.
constexpr std::uint16_t capped(std::size_t length) {
    return static_cast<std::uint16_t>(std::min<std::size_t>(length, 0xFFFF));
}

struct Step {
    std::uint64_t payload = 0;
    std::uint32_t offset = 0;  ///< of the token, from the start of the file
    std::uint16_t length = 0;  ///< of the token, capped
    Op op = Op::number;

    double number() const { return std::bit_cast<double>(payload); }
    std::uint32_t low() const { return static_cast<std::uint32_t>(payload); }
    std::uint32_t high() const { return static_cast<std::uint32_t>(payload >> 32); }
};

/// A range of steps, and the range of bytes that it was read from.
struct Expression {
    std::uint32_t begin = 0, end = 0;  ///< into File::steps; equal: there is none
    std::uint32_t offset = 0, length = 0;

    bool empty() const { return begin == end; }
};

/// A range of elements of one of the file's arrays.
struct Range {
    std::uint32_t begin = 0, end = 0;

    std::uint32_t size() const { return end - begin; }
    bool empty() const { return begin == end; }
};

/// An argument of a template's call (`name` may be missing), a parameter of a definition (`value`
/// may be missing), a part of print or assert, the end of a `for` range.
struct Argument {
    Symbol name = no_symbol;
    std::uint32_t offset = 0, length = 0;  ///< of the name
    Expression value;
};

struct Statement {
    enum class Kind : std::uint8_t {
        property,   ///< word value
        block,      ///< word [name] { body }
        call,       ///< word (arguments)
        let,        ///< let name = value
        param,      ///< param name = value
        def,        ///< def name(arguments) { body }
        func,       ///< func name(arguments) = value
        loop,       ///< for name in value [.. arguments[0]] { body }
        choice,     ///< if value { body } else { otherwise }
        include,    ///< include value
        assertion,  ///< assert value, arguments[0]
        print,      ///< print arguments
        broken,     ///< a declaration of `name` that could not be read
    };
    static constexpr std::uint32_t no_parts = 0xFFFFFFFF;

    Kind kind = Kind::property;
    bool damaged = false;            ///< its body contains a syntax error
    std::uint16_t length = 0;        ///< of the first word, capped
    std::uint32_t offset = 0;        ///< of the first word
    Symbol word = no_symbol;         ///< the first word
    std::uint32_t parts = no_parts;  ///< index into File::parts: see File::parts_of()
    Expression value;
};

static_assert(sizeof(Statement) == 32, "a long script has millions of them");

/// What most statements do not have. Most statements of a long script are properties, which have a
/// word and a value alone.
struct Parts {
    Symbol name = no_symbol;  ///< the declared name, or a block's name
    std::uint32_t name_offset = 0, name_length = 0;
    Range arguments;                 ///< into File::arguments
    Range body;                      ///< into File::statements
    std::optional<Range> otherwise;  ///< into File::statements
};

/// The place of a comment, including its delimiters.
struct Comment {
    std::uint32_t offset = 0, length = 0;
};

struct File {
    std::uint32_t source = 0;  ///< index in the SourceMap
    std::vector<Step> steps;
    std::vector<Argument> arguments;
    std::vector<Statement> statements;  ///< bodies before the statement that owns them
    std::vector<Parts> parts;           ///< of the statements that have some
    Range body;                         ///< the file's own statements
    std::vector<Comment> comments;      ///< in the order of the text
    std::vector<Symbol> variables;      ///< the variables of computed lists

    SourceSpan span(std::uint32_t offset, std::uint32_t length) const {
        return {source, offset, length};
    }
    SourceSpan span(const Statement& s) const { return span(s.offset, s.length); }
    SourceSpan span(const Expression& e) const { return span(e.offset, e.length); }
    SourceSpan span(const Step& s) const { return span(s.offset, s.length); }
    SourceSpan span(const Argument& a) const { return span(a.offset, a.length); }
    SourceSpan name_span(const Statement& s) const {
        return span(parts_of(s).name_offset, parts_of(s).name_length);
    }
    Symbol name_of(const Statement& s) const { return parts_of(s).name; }
    const Parts& parts_of(const Statement& s) const {
        static const Parts none;
        return s.parts == Statement::no_parts ? none : parts[s.parts];
    }
};

}  // namespace lancer::ast
