// Trade-offs as one page that opens in any browser without a network, and its plots as files.
#pragma once

#include <string>
#include <vector>

#include "judge/tradeoff/tradeoff.h"

namespace lancer::judge {

/// Stands in every file of a report: one without it is somebody else's.
inline constexpr const char* tradeoff_mark = "made by lancer tradeoff";

/// Names of the plots' files, one for each scene: `plot.svg`, or `plot-NAME.svg` of several.
std::vector<std::string> plot_names(const std::vector<std::string>& scenes);

/// What the pictures of the page may take.
inline constexpr std::size_t tradeoff_page_bytes = 8'500'000;

/// The whole page. Pictures that do not fit are left out: those of beaten settings first.
std::string tradeoff_page(std::vector<TradeOffReport> reports,
                          std::size_t most_bytes = tradeoff_page_bytes);

/// Writes index.html and the plots into `folder`, making it when it is missing. Throws FileError.
void write_tradeoff(std::vector<TradeOffReport> reports, const std::string& folder);

}  // namespace lancer::judge
