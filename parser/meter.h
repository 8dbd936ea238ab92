// Counts the cost of a script against its limits.
#pragma once

#include <cstdint>

#include "parser/parse.h"
#include "parser/report.h"

namespace lancer {

/// Passing a limit is reported at its place and ends the evaluation (StopReading).
class Meter {
  public:
    Meter(const Limits& limits, Report& report) : limits_(limits), report_(report) {}

    void statement(const SourceSpan& place) {
        if (++statements_ > limits_.statements)
            stop(Message::statement_limit, place, limits_.statements);
    }
    void elements(std::uint64_t count, const SourceSpan& place) {
        if (count > limits_.list_elements - elements_)
            stop(Message::element_limit, place, limits_.list_elements);
        elements_ += count;
    }
    /// Checks the bytes of lists and strings that are held at one time.
    void held(std::uint64_t bytes, const SourceSpan& place) {
        if (bytes > limits_.held_bytes) stop(Message::held_limit, place, limits_.held_bytes);
    }
    /// Counts the bytes of strings and printed lines.
    void text(std::uint64_t bytes, const SourceSpan& place) {
        if (bytes > limits_.text_bytes - text_)
            stop(Message::text_limit, place, limits_.text_bytes);
        text_ += bytes;
    }
    /// Counts the source text of one more file.
    void source(std::uint64_t bytes, const SourceSpan& place) {
        if (bytes > limits_.source_bytes - source_)
            stop(Message::source_limit, place, limits_.source_bytes);
        source_ += bytes;
    }
    const Limits& limits() const { return limits_; }
    std::uint64_t text_left() const { return limits_.text_bytes - text_; }
    std::uint64_t source_left() const { return limits_.source_bytes - source_; }

  private:
    [[noreturn]] void stop(Message message, const SourceSpan& place, std::uint64_t limit) {
        report_.error(message, place, limit);
        throw StopReading{};
    }

    const Limits& limits_;
    Report& report_;
    std::uint64_t statements_ = 0;
    std::uint64_t elements_ = 0;
    std::uint64_t text_ = 0;
    std::uint64_t source_ = 0;
};

}  // namespace lancer
