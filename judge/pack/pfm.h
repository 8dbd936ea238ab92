// Floats as a file that any language reads in ten lines.
#pragma once

#include <string>
#include <vector>

namespace lancer::judge {

/// Portable float map: "PF" (three channels) or "Pf" (one), width and height, "-1.0" for
/// little-endian; then 32-bit floats, the bottom row first. `values` are rows from the top.
std::string pfm_bytes(const std::vector<double>& values, int width, int channels);

}  // namespace lancer::judge
