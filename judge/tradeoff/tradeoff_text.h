// The costs and errors of settings as a table with advice, and as JSON.
#pragma once

#include <string>
#include <vector>

#include "judge/tradeoff/tradeoff.h"

namespace lancer::judge {

/// For people: one line per setting, from cheap to expensive, then the advice and what was left
/// out.
std::string tradeoff_text(const TradeOffReport& report);

/// Everything; docs/command-line.md describes the keys. Ends with a line feed.
std::string tradeoff_json(const std::vector<TradeOffReport>& reports);

/// The meaning of the costs, as a sentence without its full stop.
std::string cost_words(const TradeOffReport& report);

/// The bound on what the truth's limits cut, as a clause.
std::string truth_cut_words(const TradeOffReport& report);

/// "0.0031 (0.0030 to 0.0032)", or "below 0.0002" when the error is not told.
std::string error_text(const MeasuredError& error);

/// Indices of the settings from cheap to expensive.
std::vector<std::size_t> by_cost(const TradeOffReport& report);

}  // namespace lancer::judge
