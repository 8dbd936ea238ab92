// `scale=1e-6..1e6`: a change of a scene and how far, as the command line says it.
#pragma once

#include <optional>
#include <string>

#include "judge/stability/stability.h"

namespace lancer::cli {

struct ChangeRange {
    judge::Change change = judge::Change::scale;
    /// Exponents of the change's base, rounded outwards; nothing where none were given. A lower end
    /// stands only with a range.
    std::optional<int> low;
    std::optional<int> high;
    std::string text;  ///< as written
};

/// KIND, KIND=B or KIND=A..B, where A and B are numbers or powers such as 2^-40. Throws UsageError
/// that says what is expected.
ChangeRange parse_change_range(const std::string& text);

}  // namespace lancer::cli
