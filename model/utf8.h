// Is a text valid UTF-8, and what of it can be shown?
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lancer {

/// The position of the first byte from `from` on that is NUL or not part of a valid UTF-8 sequence
/// (overlong forms, surrogates and code points above U+10FFFF are not valid); npos if there is
/// none. Source: The Unicode Standard, table 3-7.
std::size_t find_invalid_utf8(std::string_view text, std::size_t from = 0);

/// The text as it can stand in one line of a message: what would end the line, move the cursor or
/// turn the direction of writing stands as an escape (`\n`, `\t`, `\x1b`, `\u202e`), and so does
/// each byte that is not UTF-8 (`\xff`). A name with a backslash of its own stays as it is.
std::string printable(std::string_view text);

/// Code points in a valid UTF-8 text.
std::size_t count_characters(std::string_view text);

}  // namespace lancer
