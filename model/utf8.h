// Is a text valid UTF-8?
#pragma once

#include <cstddef>
#include <string_view>

namespace lancer {

/// The position of the first byte from `from` on that is NUL or not part of a valid UTF-8 sequence
/// (overlong forms, surrogates and code points above U+10FFFF are not valid); npos if there is
/// none. Source: The Unicode Standard, table 3-7.
std::size_t find_invalid_utf8(std::string_view text, std::size_t from = 0);

/// Code points in a valid UTF-8 text.
std::size_t count_characters(std::string_view text);

}  // namespace lancer
