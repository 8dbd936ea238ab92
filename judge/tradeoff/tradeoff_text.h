// What settings cost and bring: as a table with advice, and as JSON.
#pragma once

#include <string>
#include <vector>

#include "judge/tradeoff/tradeoff.h"

namespace lancer::judge {

/// For people: one line a setting, from cheap to dear, then the advice and what was left out.
std::string tradeoff_text(const TradeOffReport& report);

/// Everything. Ends with a line feed. docs/command-line.md has the keys.
std::string tradeoff_json(const std::vector<TradeOffReport>& reports);

/// What costs are, as a sentence without its end.
std::string cost_words(const TradeOffReport& report);

/// How much what the truth's limits leave out can be, as a clause.
std::string truth_cut_words(const TradeOffReport& report);

/// "0.0031 (0.0030 to 0.0032)" or, where the truth cannot tell it, "below 0.0002".
std::string error_text(const MeasuredError& error);

/// Indices of the settings from cheap to dear.
std::vector<std::size_t> by_cost(const TradeOffReport& report);

}  // namespace lancer::judge
