// Checks whether text is valid UTF-8, and makes it printable.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lancer {

/// The position of the first byte from `from` on that is NUL or not part of a valid UTF-8 sequence
/// (overlong forms, surrogates and code points above U+10FFFF are invalid); npos when there is
/// none. Source: The Unicode Standard, table 3-7.
std::size_t find_invalid_utf8(std::string_view text, std::size_t from = 0);

/// The text in a form for one line of a message. Characters that would end the line, move the
/// cursor or change the direction of writing become escapes (`\n`, `\t`, `\x1b`, `\u202e`), and so
/// does each byte that is not UTF-8 (`\xff`). A backslash in a name is unchanged.
std::string printable(std::string_view text);

/// The number of code points in a valid UTF-8 text.
std::size_t count_characters(std::string_view text);

}  // namespace lancer
