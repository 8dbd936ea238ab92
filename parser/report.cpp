#include "parser/report.h"

#include <utility>

namespace lancer {
namespace {

/// The largest number of notes on the calls that led to an error.
constexpr std::size_t most_call_notes = 8;

}  // namespace

Report::Report(std::vector<Diagnostic>& found, std::uint64_t most_errors)
    : found_(found), most_errors_(most_errors) {
    for (const Diagnostic& diagnostic : found) {
        if (diagnostic.severity == Severity::error) ++errors_;
        if (diagnostic.severity == Severity::note) full_ = true;  // too_many_errors
    }
}

Diagnostic* Report::add(Severity severity, Message message, const SourceSpan& where,
                        std::string text) {
    if (full_) throw StopReading{};
    if (severity == Severity::warning && warnings_ == most_warnings) return nullptr;
    // Several warnings about one file have the same place, the file's name; their texts distinguish
    // them.
    const std::string which = severity == Severity::warning ? text : std::string();
    if (!seen_.emplace(where.file, where.offset, message, which).second) return nullptr;
    if (severity == Severity::warning) {
        ++warnings_;
    } else if (errors_++ == most_errors_) {
        full_ = true;
        found_.push_back(note(Message::too_many_errors, SourceSpan{}, most_errors_));
        throw StopReading{};
    }
    Diagnostic& diagnostic = found_.emplace_back();
    diagnostic.severity = severity;
    diagnostic.where = where;
    diagnostic.message = std::move(text);
    std::size_t shown = 0;
    for (auto call = calls.rbegin(); call != calls.rend(); ++call) {
        if (shown == most_call_notes && calls.size() > most_call_notes + 1) {
            diagnostic.notes.push_back(
                note(Message::more_calls, SourceSpan{}, calls.size() - shown));
            break;
        }
        diagnostic.notes.push_back(call->name.empty()
                                       ? note(Message::included_here, call->place)
                                       : note(Message::called_here, call->place, call->name));
        ++shown;
    }
    return &diagnostic;
}

}  // namespace lancer
