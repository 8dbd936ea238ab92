// Comparisons as text and as JSON.
#pragma once

#include <string>

#include "reference/compare/compare.h"

namespace lancer::reference {

/// A note on files that were decoded by different curves; empty when the curves are equal.
std::string curves_note(const Comparison& comparison);

/// A table with one measure per line: the value and, if there is one, its threshold; then the
/// verdict. Ends with a line feed.
std::string to_text(const Comparison& comparison, const CompareOptions& options);

/// A JSON object: "verdict" ("pass" or "fail"), "reason", "pixels", "mean", "rmse", "max", "p99",
/// "p999", "over" and more; docs/command-line.md lists the keys. Numbers that were not measured,
/// and an infinite PSNR, are null. Ends with a line feed.
std::string to_json(const Comparison& comparison, const CompareOptions& options);

}  // namespace lancer::reference
