// Collects the errors and warnings of a script: each message once per place, with the calls that
// led there, up to a maximum number.
#pragma once

#include <fmt/format.h>

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "model/diagnostic.h"
#include "parser/messages.h"

namespace lancer {

/// Thrown when the work must end: a limit was passed, or there are too many errors.
struct StopReading {};

/// A call or include that is being executed.
struct CallSite {
    SourceSpan place;
    std::string_view name;  ///< of the template or function; empty for an include
};

class Report {
  public:
    /// Adds to `found`, where the errors of an earlier stage may stand already. After `most_errors`
    /// the rest is not reported.
    Report(std::vector<Diagnostic>& found, std::uint64_t most_errors);

    /// Adds a diagnostic, unless the same message was reported for this place. Returns it, for
    /// hints and notes, or nullptr. The pointer is valid until the next call.
    template <class... Args>
    Diagnostic* error(Message message, const SourceSpan& where, const Args&... args) {
        return add(Severity::error, message, where, fill(message, args...));
    }
    template <class... Args>
    Diagnostic* warning(Message message, const SourceSpan& where, const Args&... args) {
        return add(Severity::warning, message, where, fill(message, args...));
    }

    template <class... Args>
    static Diagnostic note(Message message, const SourceSpan& where, const Args&... args) {
        return {Severity::note, where, fill(message, args...), "", {}};
    }

    /// Calls and includes that are being executed, outermost first. They become notes.
    std::vector<CallSite> calls;

    bool any_error() const { return errors_ > 0; }

    static constexpr std::size_t most_warnings = 100;

  private:
    template <class... Args>
    static std::string fill(Message message, const Args&... args) {
        return fmt::format(fmt::runtime(text_of(message)), args...);
    }
    Diagnostic* add(Severity severity, Message message, const SourceSpan& where, std::string text);

    std::vector<Diagnostic>& found_;
    const std::uint64_t most_errors_;
    std::set<std::tuple<std::uint32_t, std::uint32_t, Message, std::string>> seen_;
    std::uint64_t errors_ = 0;
    std::size_t warnings_ = 0;
    bool full_ = false;
};

}  // namespace lancer
