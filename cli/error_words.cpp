#include "cli/error_words.h"

#include <fmt/format.h>

#include <algorithm>

namespace lancer::cli {
namespace {

std::string places(const std::vector<accuracy::PixelShare>& pixels) {
    std::string text;
    for (const accuracy::PixelShare& p : pixels)
        text +=
            fmt::format("{}{},{} ({:.0f} %)", text.empty() ? "" : ", ", p.x, p.y, 100 * p.share);
    return text;
}

std::string cost(const accuracy::ErrorReport& r) {
    std::string text =
        fmt::format("{:.3g} rays per pixel; the same number in each pixel would take about {:.2g}",
                    r.rays_per_pixel, std::max(r.even_rays_per_pixel, r.rays_per_pixel));
    if (r.passes > 0) text += fmt::format("; --passes {} makes the same picture again", r.passes);
    return text;
}

std::string off_line(const accuracy::ErrorReport& r) {
    const accuracy::OffReport& off = *r.off;
    const std::string end = fmt::format(
        "of the pixels are off by more than {:g} steps of 8 bits{}, asked {:g} %; {:.3g} rays per "
        "pixel",
        off.steps, r.audited ? "" : " by the picture's own samples, not audited", 100 * off.asked,
        r.rays_per_pixel);
    if (!r.audited) return fmt::format("about {:.2g} % {}", 100 * off.predicted, end);
    return fmt::format("{:.2g} % ({:.2g} to {:.2g} %) {}", 100 * off.estimate.share,
                       100 * off.estimate.low, 100 * off.estimate.high, end);
}

}  // namespace

std::string error_line(const accuracy::ErrorReport& r) {
    if (r.off) return off_line(r);
    const accuracy::ErrorEstimate& e = r.error;
    const std::string asked =
        r.asked > 0 ? fmt::format("asked {:.3g}; {}", r.asked, cost(r)) : cost(r);
    if (!r.audited)
        return fmt::format("RMSE about {:.2g} by its own samples, not audited, {}", r.predicted,
                           asked);
    if (r.rare_light) {
        return fmt::format(
            "the error is not known: single rays met light that differs from all around it, and "
            "more of it may have been missed; pixels {}; {}",
            places(r.dominant), asked);
    }
    if (r.is_flat())
        return fmt::format("an audit of {} rays found no error, {}", r.printed.primary, asked);
    if (e.all_zero) {
        return fmt::format(
            "the error is not known: an audit of {} rays found none, but the picture's own samples "
            "differ; {}",
            r.printed.primary, asked);
    }
    if (!r.is_told) {
        return fmt::format(
            "the error is not known: a few pixels make up most of what an audit found ({:.0f} "
            "equal draws would tell as much); most of it in {}; {}",
            r.effective_draws, places(r.dominant), asked);
    }
    return fmt::format("RMSE {:.2g} ({:.2g} to {:.2g}; {:.1f} steps of 8 bits), {}", e.rmse, e.low,
                       e.high, 255 * e.rmse, asked);
}

std::vector<std::pair<std::string, std::string>> error_notes(const accuracy::ErrorReport& r) {
    const accuracy::ErrorEstimate& e = r.error;
    std::vector<std::pair<std::string, std::string>> notes;
    if (r.asked > 0) notes.emplace_back("error.asked", fmt::format("{:.6g}", r.asked));
    if (r.off) {
        notes.emplace_back("off.steps", fmt::format("{:.6g}", r.off->steps));
        notes.emplace_back("off.asked", fmt::format("{:.6g}", r.off->asked));
    }
    if (r.off && r.audited) {
        notes.emplace_back("off.share", fmt::format("{:.6g}", r.off->estimate.share));
        notes.emplace_back("off.low", fmt::format("{:.6g}", r.off->estimate.low));
        notes.emplace_back("off.high", fmt::format("{:.6g}", r.off->estimate.high));
    }
    if (r.passes > 0) notes.emplace_back("passes", fmt::format("{}", r.passes));
    if (r.audited && r.is_told) {
        notes.emplace_back("error.rmse", fmt::format("{:.6g}", e.rmse));
        notes.emplace_back("error.low", fmt::format("{:.6g}", e.low));
        notes.emplace_back("error.high", fmt::format("{:.6g}", e.high));
    }
    notes.emplace_back("rays.per_pixel", fmt::format("{:.6g}", r.rays_per_pixel));
    return notes;
}

}  // namespace lancer::cli
