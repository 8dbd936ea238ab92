// Reads words and numbers of a text file, and counts lines for messages. Independent of the locale.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "model/diagnostic.h"

namespace lancer::io {

/// Reads through `bytes`, which must outlive it. LF, CRLF and CR end a line. `comment` (when not 0)
/// begins a comment that extends to the end of the line. `continuation` (when not 0) directly
/// before the end of a line joins the next line to it.
class TextScanner {
  public:
    TextScanner(std::string_view bytes, std::string name, char comment = 0, char continuation = 0,
                std::uint32_t first_line = 1)
        : at_(bytes.data()),
          end_(bytes.data() + bytes.size()),
          name_(std::move(name)),
          line_(first_line),
          comment_(comment),
          continuation_(continuation) {}

    /// Skips spaces and comments, but no line ends; true at the end of the line or file.
    bool at_line_end();
    /// Skips the rest of the line and its end.
    void next_line();
    /// Skips spaces, comments and line ends; true at the end of the file.
    bool at_end();
    /// The rest of the line, including spaces, without its end, which is skipped.
    std::string_view rest_of_line();

    /// The next word of this line, up to a space or end of line; empty at the end of the line.
    std::string_view word();
    /// The next number on this line: a finite double; a number too small for the type becomes 0.
    /// Throws FileError, which names `what`, when there is none, when it is not finite or too
    /// large, or when a letter follows.
    double number(const char* what);
    /// The same, but NaN, infinity and values too large for a double are allowed.
    double any_number(const char* what);
    /// The integer that begins exactly here; no digit, letter or point may follow it.
    std::int64_t integer(const char* what);
    /// If `c` is the very next character, skips it and returns true.
    bool skip(char c);
    /// Whether the next word of this line begins with `c`.
    bool next_word_begins(char c) { return !at_line_end() && *at_ == c; }
    /// Whether the next word of this line is a number.
    bool next_is_number();
    bool next_is(char c) const { return at_ != end_ && *at_ == c; }
    /// Whether a blank, a comment or the end of the line follows.
    bool at_word_end() const { return is_word_end(at_); }

    std::uint32_t line() const { return line_; }
    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
    /// "name:line: message"
    FileError error(const std::string& message) const;

  private:
    bool is_line_end(const char* p) const { return p == end_ || *p == '\n' || *p == '\r'; }
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    bool is_word_end(const char* p) const {
        return is_line_end(p) || is_blank(*p) || (comment_ != 0 && *p == comment_);
    }
    void skip_line_end();
    bool skip_continuation();
    FileError not_a(const char* what, const char* from) const;

    const char* at_;
    const char* end_;
    std::string name_;
    std::uint32_t line_;
    char comment_;
    char continuation_;
};

/// A short piece of a file for a message, without characters that a terminal would interpret.
std::string quotable(std::string_view text);

}  // namespace lancer::io
