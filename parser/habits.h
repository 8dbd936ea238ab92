// What people write who come from other programs, and what this language has instead: for hints.
#pragma once

#include <string>
#include <string_view>

namespace lancer::habits {

/// What to write instead of a word of another language (a block, a property, a statement, an
/// operator, a function), as a hint; empty when the word is not a known one.
std::string_view instead_of(std::string_view word);

/// What has parameters here: where one kind is written as the other.
inline constexpr std::string_view callables =
    "use 'func name(a, b) = ...' for a value, 'def name(a, b) { ... }' for statements";

/// How a list is computed here.
inline constexpr std::string_view computed = "[for i in 0..10 if i % 2 == 0: i * i]";

/// A word that begins a statement elsewhere and that is followed by something other than a value:
/// `while x < 3 {`, `elif`, `function f() {`.
bool begins_foreign_statement(std::string_view word);
/// A word that stands before `name = value` elsewhere, as `const` and `var` do.
bool declares(std::string_view word);

/// A word before the numbers of a colour elsewhere: `rgb <1, 0, 0>`.
bool announces_color(std::string_view word);
/// The hint for a colour that is written as its name alone; empty when it is none.
std::string color_called(std::string_view name);

/// `mm`, `deg` and the like.
bool is_unit(std::string_view word);
/// The hint for a number with such a unit.
std::string_view about_unit(std::string_view unit);

/// The hint for a directive of POV-Ray or of a preprocessor, without its `#`.
std::string_view instead_of_directive(std::string_view word);

/// The hint for the character at the start of `text`, when it only looks like one of the language
/// (curly quotes, a long minus) or is a letter with an accent; empty otherwise.
std::string_view about_character(std::string_view text);

/// "a vector is written [0, 1, 5]" from what stands between other brackets, or with `otherwise`
/// where that is no short list of two or three.
std::string vector_hint(std::string_view inside, std::string_view what = "a vector",
                        std::string_view otherwise = "x, y, z");

}  // namespace lancer::habits
