// Recommends settings for given errors.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lancer::judge {

struct Measurement;

struct Advice {
    double below = 0;        ///< the target error
    std::string below_text;  ///< "1/255"
    /// index of the fastest frontier setting that is surely below it
    std::optional<std::size_t> use;
    double times_as_fast = 1;  ///< compared with the exact setting
};

/// Advice for common target errors, from coarse to fine. A setting counts with the upper end of its
/// error interval.
std::vector<Advice> advice_from(const std::vector<Measurement>& settings, std::size_t exact);

/// "for an error below 1/255: `--samples 3 ...`, 7.3 times as fast as exact (RMSE 0.0031)".
std::string sentence(const Advice& advice, const std::vector<Measurement>& settings);

}  // namespace lancer::judge
