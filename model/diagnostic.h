// Errors and warnings about a user's scene. All stages collect them, only cli/ prints them.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "model/source.h"

namespace lancer {

enum class Severity { error, warning, note };

struct Diagnostic {
    Severity severity = Severity::error;
    SourceSpan where;     ///< may be `nowhere`: then no place is printed
    std::string message;  ///< one sentence, lower case, no full stop
    std::string hint;     ///< what to write instead; may be empty
    std::vector<Diagnostic>
        notes;  ///< first definition, opener, call stack; they have no notes themselves
};

/// Formats the diagnostic like a compiler:
///     file:line:column: error: message
///         source line, cropped to about 100 bytes around the caret
///             ^~~~
///         hint: …
/// followed by its notes. Ends with a line feed.
std::string format(const Diagnostic& diagnostic, const SourceMap& sources);

/// A scene that cannot be rendered or exported, found after evaluation (by compile or export).
struct SceneError : std::runtime_error {
    SceneError(const SourceSpan& span, const std::string& message)
        : std::runtime_error(message), where(span) {}
    SourceSpan where;
};

/// A failure outside of the scene: a file that cannot be read or written, POV-Ray missing or
/// failing. Caught once in cli/, exit code 4.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace lancer
