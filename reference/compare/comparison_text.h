// A comparison for people and for programs.
#pragma once

#include <string>

#include "reference/compare/compare.h"

namespace lancer::reference {

/// What to say of files that were decoded by different curves; empty when they were not.
std::string curves_note(const Comparison& comparison);

/// A table, one measure to a line with the achieved value and, where there is one, the threshold
/// beside it; then the verdict. Ends with a line feed.
std::string to_text(const Comparison& comparison, const CompareOptions& options);

/// A JSON object: "verdict" ("pass" or "fail"), "reason", "pixels", "mean", "rmse", "max", "p99",
/// "p999", "over" and more; docs/language.md lists the keys. Numbers that were not measured, and a
/// PSNR that is infinite, are null. Ends with a line feed.
std::string to_json(const Comparison& comparison, const CompareOptions& options);

}  // namespace lancer::reference
