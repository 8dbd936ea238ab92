// One pair of pictures as HTML.
#pragma once

#include <string>

#include "judge/report/report.h"

namespace lancer::judge {

/// "differs" and so on: the class in the style sheet and the word on the page.
std::string verdict_name(Verdict verdict);

/// The card with pictures, measures and evidence. `rank` is its position by urgency.
std::string entry_card(const ReportEntry& entry, const Report& report, std::size_t rank);

/// The entry's line in the table at the top.
std::string entry_row(const ReportEntry& entry, const Report& report, std::size_t rank);

}  // namespace lancer::judge
