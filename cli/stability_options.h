// `scale=1e-6..1e6`: a change of a scene and its range, as given on the command line.
#pragma once

#include <optional>
#include <string>

#include "judge/stability/stability.h"

namespace lancer::cli {

struct ChangeRange {
    judge::Change change = judge::Change::scale;
    /// Exponents of the change's base, rounded outwards; nothing when not given. `low` is set only
    /// when a range was given.
    std::optional<int> low;
    std::optional<int> high;
    std::string text;  ///< as written by the user
};

/// Parses KIND, KIND=B or KIND=A..B, where A and B are numbers or powers such as 2^-40. Throws
/// UsageError, which says what is expected.
ChangeRange parse_change_range(const std::string& text);

}  // namespace lancer::cli
