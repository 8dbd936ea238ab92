// Recommends settings for given errors.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lancer::judge {

struct Measurement;

struct Advice {
    double below = 0;                ///< the error
    std::string below_text;          ///< "1/255"
    std::optional<std::size_t> use;  ///< index of the fastest of the frontier that is surely below
    double times_as_fast = 1;        ///< as the exact one
};

/// Advice for common target errors, from coarse to fine. A setting counts with the upper end of its
/// error interval.
std::vector<Advice> advice_from(const std::vector<Measurement>& settings, std::size_t exact);

/// "for an error below 1/255: `--samples 3 ...`, 7.3 times as fast as exact (RMSE 0.0031)".
std::string sentence(const Advice& advice, const std::vector<Measurement>& settings);

}  // namespace lancer::judge
