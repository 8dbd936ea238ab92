// Renders the same scene at other sizes in POV-Ray, without the export scale.
#include <algorithm>

#include "judge/stability/stability.h"
#include "model/diagnostic.h"

namespace lancer::judge {
namespace {

// Around the best size POV-Ray is right over about six powers of ten; these limits show both ends.
constexpr int smaller = 9;
constexpr int larger = 7;

}  // namespace

PovRayWindow povray_window(const Scene& scene, const reference::ExportView& view,
                           const reference::PovRay& povray,
                           const reference::PovOptions& pov_options,
                           const StabilityOptions& options) {
    PovRayWindow result;
    result.version = povray.version;
    const reference::ExportResult at_best = reference::export_pov(scene, view);
    if (!at_best.refusals.empty()) {
        result.failure = at_best.refusals.front().message;
        return result;
    }
    result.best = at_best.decades;

    const auto job_at = [&](int exponent) {
        const reference::ExportResult exported =
            reference::export_pov(scene, view, {.decades = exponent});
        return reference::PovJob{"the scene", exported.text, exported.assets, view.width,
                                 view.height};
    };
    std::vector<reference::PovJob> jobs{job_at(result.best)};
    for (int k = result.best - smaller; k <= result.best + larger; ++k) {
        if (k != result.best) jobs.push_back(job_at(k));
    }
    const std::vector<reference::PovOutcome> outcomes =
        reference::run_povray_jobs(povray, jobs, pov_options);
    if (!outcomes.front().picture) {
        result.failure = outcomes.front().failure;
        return result;
    }
    const Image& reference = outcomes.front().picture->image;
    std::size_t next = 1;
    for (int k = result.best - smaller; k <= result.best + larger; ++k) {
        const reference::PovOutcome& outcome = outcomes[k == result.best ? 0 : next++];
        if (outcome.picture) {
            result.samples.push_back(compare_to(reference, outcome.picture->image, k, options));
            continue;
        }
        Sample failed;
        failed.exponent = k;
        failed.failure = outcome.failure;
        failed.wrong = failed.different = reference.data.size() / 3;
        failed.most = 1;
        result.samples.push_back(failed);
    }
    result.lowest = result.highest = result.best;
    const auto right = [&](int k) {
        const int i = k - (result.best - smaller);
        return i >= 0 && i < static_cast<int>(result.samples.size()) &&
               result.samples[static_cast<std::size_t>(i)].right;
    };
    while (right(result.lowest - 1)) --result.lowest;
    while (right(result.highest + 1)) ++result.highest;
    return result;
}

}  // namespace lancer::judge
