// Settings chosen by one word, for different purposes.
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

/// The settings that a quality determines; all others are unchanged.
struct QualityValues {
    int samples;
    Sampling sampling;
    int max_depth;
    double min_contribution;
};
/// Chosen from measurements of the gallery: docs/cost-of-accuracy.md, "Presets".
const QualityValues& values_of(Quality quality);

void apply(const QualityValues& values, Settings& settings);

}  // namespace lancer
