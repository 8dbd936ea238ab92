// Reads script text without the grammar: for lookahead, messages and recovery.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace lancer::scan {

constexpr bool is_name_start(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
constexpr bool is_name_part(char c) {
    return is_name_start(c) || is_digit(c);
}
constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}
constexpr bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

/// The end of the line that contains `at`: its LF, CRLF or CR, or the end of the text.
std::size_t line_end(std::string_view text, std::size_t at);

/// Words that cannot be names.
inline constexpr std::array<std::string_view, 13> reserved_words{
    "include", "let",  "param",  "def",   "func", "for",  "in",
    "if",      "else", "assert", "print", "true", "false"};
bool is_reserved(std::string_view word);
/// A reserved word that begins a statement.
bool begins_statement(std::string_view word);

/// The position after the blanks and comments at `at`. A comment that is not closed extends to the
/// end of the text.
std::size_t skip_blanks(std::string_view text, std::size_t at);

struct Token {
    enum class Kind { end, name, number, string, open, close, open_brace, close_brace, other };
    Kind kind = Kind::end;
    std::size_t begin = 0, end = 0;
};
/// The token at `at` or after the blanks there. A string that is not closed extends to the end of
/// its line.
Token next_token(std::string_view text, std::size_t at);

/// Whether only blanks stand before `at` on its line.
bool is_first_on_line(std::string_view text, std::size_t at);
/// The number of blanks before the first token of the line that contains `at`.
std::size_t indentation(std::string_view text, std::size_t at);

}  // namespace lancer::scan
