#include "accuracy/deciding_audits.h"

#include <algorithm>

#include "model/elementary.h"

namespace lancer::accuracy {
namespace {

constexpr double sure_effective_draws = 2 * least_effective_draws;

}  // namespace

int most_draws(const PictureSamples& samples) {
    const std::uint64_t most =
        std::max<std::uint64_t>(samples.size() / 4, samples.rays().primary / 32);
    return static_cast<int>(std::clamp<std::uint64_t>(most, 1000, 16000));
}

DecidingAudits::DecidingAudits(const Truth& truth, double max_error)
    : truth_(truth), goal_(max_error * max_error) {}

Audit DecidingAudits::taken(const PictureSamples& samples, const Prediction& prediction, int draws,
                            RayCounts& rays) {
    Audit a = audit(truth_, samples, prediction.errors(samples), {draws, audits_++, shares_}, {});
    rays += a.rays;
    return a;
}

Audit DecidingAudits::separate(const PictureSamples& samples, const Prediction& prediction,
                               RayCounts& rays) {
    return taken(samples, prediction, draws_, rays);
}

ErrorEstimate DecidingAudits::first(const PictureSamples& samples, const Prediction& prediction,
                                    RayCounts& rays) {
    last_ = taken(samples, prediction, first_draws, rays);
    return estimate(last_.terms);
}

ErrorEstimate DecidingAudits::judge(const PictureSamples& samples, const Prediction& prediction,
                                    RayCounts& rays) {
    const int most = most_draws(samples);
    const auto add = [&](int draws) {
        last_.add(taken(samples, prediction, draws, rays));
        return estimate(last_.terms);
    };
    for (;;) {
        last_ = taken(samples, prediction, (draws_ + 1) / 2, rays);
        ErrorEstimate e = estimate(last_.terms);
        if (is_decided(e)) return e;
        e = add(draws_ / 2);
        if (e.all_zero || e.effective_draws >= least_effective_draws) return e;
        if (2 * e.effective_draws >= least_effective_draws && 2 * draws_ <= most) {
            e = add(draws_);
            draws_ *= 2;
            if (e.effective_draws >= least_effective_draws) return e;
        }
        if (draws_ >= most) return e;
        draws_ = std::min(most, 2 * draws_);
        learn_shares();
    }
}

bool DecidingAudits::is_decided(const ErrorEstimate& e) const {
    if (e.effective_draws < least_effective_draws || e.mean_square <= 0) return false;
    const double above = e.mean_square * elementary::exp(-deciding_margin * e.log_error());
    if (above > goal_) return true;
    return e.effective_draws >= sure_effective_draws && is_below(e, deciding_margin);
}

bool DecidingAudits::is_below(const ErrorEstimate& e, double margin) const {
    if (e.all_zero) return true;
    if (e.mean_square <= 0) return false;
    return e.mean_square * elementary::exp(margin * e.log_error()) <= goal_;
}

}  // namespace lancer::accuracy
