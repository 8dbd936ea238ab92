// A plot of time against error, both logarithmic, with a point for each setting, as SVG.
#pragma once

#include <string>

#include "judge/tradeoff/tradeoff.h"

namespace lancer::judge {

/// A group of knobs in the legend: its name and class. Only knobs that the report's settings change
/// are listed.
struct KnobGroup {
    std::string name;
    std::string style;  ///< class in the style sheet
};
KnobGroup group_of(Knob knob);

/// The drawing for a page: points are links to `#prefix` and the setting's index; the page's style
/// sheet defines the colours.
std::string scatter_for_page(const TradeOffReport& report, const std::string& prefix);

/// A complete SVG document with its own colours and a legend. It contains tradeoff_mark.
std::string scatter_document(const TradeOffReport& report);

/// A point for the legend: an SVG of 12 by 12 pixels.
std::string scatter_key(Knob knob);

}  // namespace lancer::judge
