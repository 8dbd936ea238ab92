#include "parser/scan.h"

#include <algorithm>

namespace lancer::scan {

std::size_t line_end(std::string_view text, std::size_t at) {
    return std::min(text.find_first_of("\r\n", at), text.size());
}

bool is_reserved(std::string_view word) {
    // The first letter alone rules out most words.
    static constexpr std::uint32_t beginnings = [] {
        std::uint32_t bits = 0;
        for (const std::string_view reserved : reserved_words) bits |= 1U << (reserved[0] - 'a');
        return bits;
    }();
    if (word[0] < 'a' || word[0] > 'z' || (beginnings >> (word[0] - 'a') & 1) == 0) return false;
    for (const std::string_view reserved : reserved_words)
        if (word[0] == reserved[0] && word == reserved) return true;
    return false;
}

bool begins_statement(std::string_view word) {
    return is_reserved(word) && word != "in" && word != "else" && word != "true" && word != "false";
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
    while (at < text.size()) {
        if (is_blank(text[at])) {
            ++at;
        } else if (text[at] == '/' && at + 1 < text.size() && text[at + 1] == '/') {
            at = line_end(text, at);
        } else if (text[at] == '/' && at + 1 < text.size() && text[at + 1] == '*') {
            const std::size_t close = text.find("*/", at + 2);
            at = close == std::string_view::npos ? text.size() : close + 2;
        } else {
            break;
        }
    }
    return at;
}

Token next_token(std::string_view text, std::size_t at) {
    using Kind = Token::Kind;
    at = skip_blanks(text, at);
    if (at >= text.size()) return {Kind::end, text.size(), text.size()};
    const char c = text[at];
    std::size_t end = at + 1;
    const bool fraction = c == '.' && end < text.size() && is_digit(text[end]);
    if (is_name_start(c)) {
        while (end < text.size() && is_name_part(text[end])) ++end;
        return {Kind::name, at, end};
    }
    if (is_digit(c) || fraction) {
        while (end < text.size() && (is_name_part(text[end]) || text[end] == '.')) ++end;
        return {Kind::number, at, end};
    }
    if (c == '#') {
        while (end < text.size() && is_name_part(text[end])) ++end;
        return {Kind::number, at, end};
    }
    if (c == '"') {
        while (end < text.size() && text[end] != '"' && !is_line_end(text[end]))
            end +=
                text[end] == '\\' && end + 1 < text.size() && !is_line_end(text[end + 1]) ? 2 : 1;
        end = std::min(end, text.size());
        if (end < text.size() && text[end] == '"') ++end;
        return {Kind::string, at, end};
    }
    switch (c) {
        case '(':
        case '[':
            return {Kind::open, at, end};
        case ')':
        case ']':
            return {Kind::close, at, end};
        case '{':
            return {Kind::open_brace, at, end};
        case '}':
            return {Kind::close_brace, at, end};
        default:
            break;
    }
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
    return {Kind::other, at, end};
}

bool is_first_on_line(std::string_view text, std::size_t at) {
    while (at > 0 && !is_line_end(text[at - 1])) {
        if (!is_blank(text[at - 1])) return false;
        --at;
    }
    return true;
}

std::size_t indentation(std::string_view text, std::size_t at) {
    std::size_t begin = at;
    while (begin > 0 && !is_line_end(text[begin - 1])) --begin;
    std::size_t first = begin;
    while (first < at && is_blank(text[first])) ++first;
    return first - begin;
}

}  // namespace lancer::scan
