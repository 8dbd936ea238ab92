#include "model/io/text_scanner.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace lancer::io {
namespace {

/// Whether a decimal number that does not fit a double is too small and not too large. Decided by
/// the power of ten of its first digit that is not 0.
bool is_tiny(std::string_view number) {
    const std::size_t e = number.find_first_of("eE");
    const std::string_view digits = number.substr(0, e);
    const std::size_t first = digits.find_first_of("123456789");
    if (first == std::string_view::npos) return true;
    const std::size_t point = std::min(digits.find('.'), digits.size());
    std::int64_t exponent = 0;
    if (e != std::string_view::npos) {
        std::string_view text = number.substr(e + 1);
        if (text.starts_with('+')) text.remove_prefix(1);
        const auto result = std::from_chars(text.data(), text.data() + text.size(), exponent);
        if (result.ec != std::errc()) return text.starts_with('-');
    }
    const std::int64_t place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
    // Exponents longer than any file have the same effect; clamping them prevents an overflow of
    // the sum.
    constexpr std::int64_t beyond = std::int64_t{1} << 60;
    return std::min(std::max(exponent, -beyond), beyond) + place < 0;
}

bool is_name_character(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
           c == '_' || c == '+' || c == '-';
}

}  // namespace

std::string quotable(std::string_view text) {
    std::string shown;
    for (const char c : text.substr(0, 30)) shown += c > 0x20 && c < 0x7F ? c : '?';
    return shown + (text.size() > 30 ? "..." : "");
}

void TextScanner::skip_line_end() {
    if (at_ == end_) return;
    if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
    ++at_;
    ++line_;
}

bool TextScanner::skip_continuation() {
    if (continuation_ == 0 || at_ == end_ || *at_ != continuation_) return false;
    if (at_ + 1 == end_ || !is_line_end(at_ + 1)) return false;
    ++at_;
    skip_line_end();
    return true;
}

bool TextScanner::at_line_end() {
    while (at_ != end_ && (is_blank(*at_) || skip_continuation())) {
        if (at_ != end_ && is_blank(*at_)) ++at_;
    }
    if (comment_ != 0 && at_ != end_ && *at_ == comment_) {
        while (!is_line_end(at_)) ++at_;
    }
    return is_line_end(at_);
}

void TextScanner::next_line() {
    while (!is_line_end(at_)) {
        if (!skip_continuation()) ++at_;
    }
    skip_line_end();
}

bool TextScanner::at_end() {
    while (at_line_end()) {
        if (at_ == end_) return true;
        skip_line_end();
    }
    return false;
}

std::string_view TextScanner::rest_of_line() {
    const char* from = at_;
    while (!is_line_end(at_)) ++at_;
    const std::string_view rest(from, static_cast<std::size_t>(at_ - from));
    skip_line_end();
    return rest;
}

std::string_view TextScanner::word() {
    at_line_end();
    const char* from = at_;
    while (!is_word_end(at_)) ++at_;
    return {from, static_cast<std::size_t>(at_ - from)};
}

double TextScanner::number(const char* what) {
    at_line_end();
    const char* from = at_;
    const double value = any_number(what);
    if (std::isfinite(value)) return value;
    const std::string_view text(from, static_cast<std::size_t>(at_ - from));
    throw this->error(fmt::format("{} is not finite: '{}'", what, quotable(text)));
}

double TextScanner::any_number(const char* what) {
    at_line_end();
    const char* from = at_;
    if (at_ != end_ && *at_ == '+' && at_ + 1 != end_ && at_[1] != '-') ++at_;
    double value = 0;
    const auto [after, error] = std::from_chars(at_, end_, value);
    if (error == std::errc::invalid_argument || !is_word_end(after)) throw not_a(what, from);
    const std::string_view text(at_, static_cast<std::size_t>(after - at_));
    at_ = after;
    if (error == std::errc::result_out_of_range) {
        const bool negative = text.starts_with('-');
        if (is_tiny(text)) return negative ? -0.0 : 0.0;
        return negative ? -HUGE_VAL : HUGE_VAL;
    }
    return value;
}

bool TextScanner::next_is_number() {
    if (at_line_end()) return false;
    double value = 0;
    const auto [after, error] = std::from_chars(at_, end_, value);
    return error == std::errc() && is_word_end(after);
}

std::int64_t TextScanner::integer(const char* what) {
    const char* from = at_;
    if (at_ != end_ && *at_ == '+' && at_ + 1 != end_ && at_[1] != '-') ++at_;
    std::int64_t value = 0;
    const auto [after, error] = std::from_chars(at_, end_, value);
    if (error != std::errc() || (after != end_ && is_name_character(*after))) {
        throw not_a(what, from);
    }
    at_ = after;
    return value;
}

bool TextScanner::skip(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
}

FileError TextScanner::error(const std::string& message) const {
    return FileError(fmt::format("{}:{}: {}", name_, line_, message));
}

FileError TextScanner::not_a(const char* what, const char* from) const {
    const char* to = from;
    while (!is_word_end(to)) ++to;
    if (from == to) return error(fmt::format("{} expected, but the line ends", what));
    return error(fmt::format("{} expected, not '{}'", what,
                             quotable({from, static_cast<std::size_t>(to - from)})));
}

}  // namespace lancer::io
