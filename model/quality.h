// Settings by one word: as much time as a purpose is worth.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "model/settings.h"

namespace lancer {

enum class Quality : std::uint8_t { draft, normal, fine, exact };

inline constexpr std::array all_qualities{Quality::draft, Quality::normal, Quality::fine,
                                          Quality::exact};
std::string_view name_of(Quality quality);

/// What a quality decides; all else stays as it is.
struct QualityValues {
    int samples;
    Sampling sampling;
    int max_depth;
    double min_contribution;
};
/// From what settings cost and bring in the gallery: docs/cost-of-accuracy.md, "Presets".
const QualityValues& values_of(Quality quality);

void apply(const QualityValues& values, Settings& settings);

}  // namespace lancer
