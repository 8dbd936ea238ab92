// Hints for habits from other programs: what this language has instead.
#pragma once

#include <string>
#include <string_view>

namespace lancer::habits {

/// A hint what to write instead of a word of another language (a block, property, statement,
/// operator or function). Empty when the word is unknown.
std::string_view instead_of(std::string_view word);

/// A hint for a function that is written as a template, or the other way round.
inline constexpr std::string_view callables =
    "use 'func name(a, b) = ...' for a value, 'def name(a, b) { ... }' for statements";

/// An example of a computed list.
inline constexpr std::string_view computed = "[for i in 0..10 if i % 2 == 0: i * i]";

/// Whether the word begins a statement in other languages. It must be followed by something other
/// than a value: `while x < 3 {`, `elif`, `function f() {`.
bool begins_foreign_statement(std::string_view word);
/// Whether the word stands before `name = value` in other languages, such as `const` and `var`.
bool declares(std::string_view word);

/// Whether the word stands before the numbers of a colour in other languages: `rgb <1, 0, 0>`.
bool announces_color(std::string_view word);
/// The hint for a colour that is written as its bare name; empty when there is no such colour.
std::string color_called(std::string_view name);

/// Whether the word is a unit: `mm`, `deg` and the like.
bool is_unit(std::string_view word);
/// The hint for a number with such a unit.
std::string_view about_unit(std::string_view unit);

/// The hint for a directive of POV-Ray or of a preprocessor, given without its `#`.
std::string_view instead_of_directive(std::string_view word);

/// The hint for the character at the start of `text` when it only looks like a character of the
/// language (curly quotes, a long minus) or is a letter with an accent; otherwise empty.
std::string_view about_character(std::string_view text);

/// "a vector is written [0, 1, 5]", made from the text between other brackets. Uses `otherwise`
/// when that text is not a list of two or three short items.
std::string vector_hint(std::string_view inside, std::string_view what = "a vector",
                        std::string_view otherwise = "x, y, z");

}  // namespace lancer::habits
