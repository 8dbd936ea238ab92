// A histogram of the pixels' differences.
#pragma once

#include <string>
#include <vector>

namespace lancer::judge {

/// An SVG with both axes logarithmic: differences from 1e-7 (all smaller ones are in the first bar)
/// to 1, five bars per factor of ten. `marks` are thresholds, drawn as dashed lines.
std::string histogram_svg(const std::vector<double>& differences, const std::vector<double>& marks);

}  // namespace lancer::judge
