#include "cli/cut_words.h"

#include <fmt/format.h>

#include <cmath>

namespace lancer::cli {

std::string cut_line(const accuracy::CutBound& cut, const TraceLimits& limits) {
    constexpr double half_a_step = 0.5 / 65535 / 12.92;
    if (cut.largest == 0) return "nothing was cut";
    if (!std::isfinite(cut.largest))
        return "what was cut has no bound: surfaces send on more light than they get";
    const bool goes_deeper = limits.max_depth < 1000 || limits.min_contribution > 1e-12;
    return fmt::format(
        "what was cut changes no pixel by more than {:.2g} (RMSE at most {:.2g}): {}", cut.largest,
        cut.rmse,
        cut.largest < half_a_step ? "too little for 16 bits to show"
        : goes_deeper ? "a larger --max-depth or a smaller --min-contribution may cut less"
                      : "some light never leaves the surfaces that reflect all of it");
}

}  // namespace lancer::cli
