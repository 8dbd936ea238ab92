// The trade-offs as one page that any browser can open without a network, and its plots as files.
#pragma once

#include <string>
#include <vector>

#include "judge/tradeoff/tradeoff.h"

namespace lancer::judge {

/// A mark in every file of a report. A file without it does not belong to a report and must not be
/// replaced.
inline constexpr const char* tradeoff_mark = "made by lancer tradeoff";

/// The names of the plots' files, one per scene: `plot.svg`, or `plot-NAME.svg` for several scenes.
std::vector<std::string> plot_names(const std::vector<std::string>& scenes);

/// The limit on the pictures of the page.
inline constexpr std::size_t tradeoff_page_bytes = 8'500'000;

/// The whole page. Pictures that do not fit are dropped, those of beaten settings first.
std::string tradeoff_page(std::vector<TradeOffReport> reports,
                          std::size_t most_bytes = tradeoff_page_bytes);

/// Writes index.html and the plots into `folder`, which is created when it is missing. Throws
/// FileError.
void write_tradeoff(std::vector<TradeOffReport> reports, const std::string& folder);

}  // namespace lancer::judge
