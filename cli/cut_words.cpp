#include "cli/cut_words.h"

#include <fmt/format.h>

#include <cmath>

#include "model/quality.h"

namespace lancer::cli {

std::string cut_line(const accuracy::CutBound& cut) {
    constexpr double half_a_step = 0.5 / 65535 / 12.92;
    if (cut.largest == 0) return "nothing was cut";
    if (!std::isfinite(cut.largest))
        return "the light that was cut has no bound: surfaces send on more light than they receive";
    const QualityValues& exact = values_of(Quality::exact);
    const bool goes_deeper = cut.limits.max_depth < exact.max_depth ||
                             cut.limits.min_contribution > exact.min_contribution;
    return fmt::format(
        "the light that was cut changes no pixel by more than {:.2g} (RMSE at most {:.2g}): {}",
        cut.largest, cut.rmse,
        cut.largest < half_a_step ? "too little to show in 16 bits"
        : goes_deeper ? "a larger --max-depth or a smaller --min-contribution may cut less"
                      : "some light never leaves the surfaces that reflect all of it");
}

}  // namespace lancer::cli
