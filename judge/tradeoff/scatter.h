// Time against error, both logarithmic, a point for each setting: as SVG.
#pragma once

#include <string>

#include "judge/tradeoff/tradeoff.h"

namespace lancer::judge {

/// The knobs' names and class names, for a legend: those that the report's settings turn.
struct KnobGroup {
    std::string name;
    std::string style;  ///< class in the style sheet
};
KnobGroup group_of(Knob knob);

/// The drawing of a page: points are links to `#prefix` and the setting's index, and the page's
/// style sheet gives colours.
std::string scatter_for_page(const TradeOffReport& report, const std::string& prefix);

/// A whole SVG document with its own colours and a legend. Holds tradeoff_mark.
std::string scatter_document(const TradeOffReport& report);

/// A point of the legend: an SVG of 12 by 12 pixels.
std::string scatter_key(Knob knob);

}  // namespace lancer::judge
