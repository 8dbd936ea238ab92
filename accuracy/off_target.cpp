#include "accuracy/off_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "accuracy/binomial.h"
#include "accuracy/off_allocation.h"

namespace lancer::accuracy {
namespace {

constexpr std::uint32_t base = 2;  // samples per pixel; a single one has no variance
constexpr int most_rounds = 6;
// Draws of an audit that treats all pixels alike, times the share: about the number of draws off
// if the share is reached.
constexpr double draws_by_share = 12;
constexpr int fewest_draws = 400;
// Factors on these draws. Risky pixels get a few more. Of the calm pixels hardly any is off, and
// 3.7 / share draws are enough to show that they hold less than the share. A deciding audit takes
// half as many of them.
constexpr double risky_draws = 13.0 / 12;
constexpr double calm_draws = 0.5;
constexpr double calm_draws_to_decide = 0.25;
constexpr double calm_share = 0.003;  // predicted share of calm pixels off, of the share asked for
constexpr double no_better = 0.8;     // of the last share: a round that lowers it less failed
constexpr double likely = 0.977;  // probability that the printed audit confirms the deciding one

class Search {
  public:
    Search(const Renderer& renderer, const Truth& truth, const View& view, const OffGoal& goal,
           const Progress& progress)
        : renderer_(renderer), truth_(truth), view_(view), goal_(goal), progress_(progress) {
        draws_ = std::max<double>(fewest_draws, std::ceil(draws_by_share / goal.share));
        report_.off.emplace();
        report_.off->asked = goal.share;
        report_.off->steps = goal.steps;
        // By Chebyshev's inequality: with this mean square over channels, the cuts put at most a
        // tenth of the share off by more than half the threshold.
        const double cut = goal.share / 10 * goal.threshold() * goal.threshold() / 12;
        report_.limits = cheapest_limits(truth, view, goal.fixed, cut, goal.seed, report_.deciding);
        take_samples();
        share_draws();
        check_settings();
        most_rays_ = goal.most_rays_per_pixel * static_cast<double>(samples_->size());
    }

    ErrorPicture run() {
        begin();
        if (goal_.audited) {
            decide();
            print();
        } else {
            refine_to(goal_.share / 2);
        }
        report_.off->predicted = predicted_off(*samples_, prediction_, goal_.threshold());
        OffSums off;
        off.asked = goal_.share;
        off.steps = goal_.steps;
        off.predicted = report_.off->predicted * static_cast<double>(samples_->size());
        off.printed = printed_;
        ErrorSums sums;
        sums.off = off;
        return finished(*samples_, prediction_, std::move(report_), std::move(sums));
    }

  private:
    Progress pace() const {
        if (!progress_) return {};
        return [this](double) {
            const double made = static_cast<double>(samples_->rays().primary);
            progress_(std::min(0.99, made / std::max(1.0, expected_)));
        };
    }

    void take_samples() {
        samples_.emplace(renderer_, view_, report_.limits, goal_.seed,
                         goal_.rows.value_or(PictureRows{}));
    }

    /// All parts have the same number of draws per pixel, whatever their sizes.
    void share_draws() {
        if (!goal_.rows) return;
        const double rows = view_.crop ? view_.crop->height : view_.height;
        draws_ = std::ceil(draws_ * goal_.rows->parts * (samples_->height() / rows));
    }

    /// Throws if the settings that the user fixed put more pixels off than the goal allows.
    void check_settings() {
        if (!goal_.leaves_out && !goal_.fixed.max_depth && !goal_.fixed.min_contribution) return;
        OffPlan plan;
        plan.calm.resize(samples_->size());
        std::iota(plan.calm.begin(), plan.calm.end(), std::size_t(0));
        plan.calm_draws = static_cast<std::uint64_t>(draws_);
        plan.number = audits_++;
        plan.threshold = goal_.threshold();
        const OffCount count = count_left_out(truth_, renderer_, report_.limits, *samples_, plan);
        report_.deciding += count.rays;
        const OffEstimate left_out = estimate(count);
        if (left_out.low <= goal_.share) return;
        throw Unreachable(
            fmt::format("at most {:g} % off by more than {:g} steps cannot be reached with these "
                        "settings: what they leave out already puts {:.2g} % off",
                        100 * goal_.share, goal_.steps, 100 * left_out.share));
    }

    void begin() {
        expected_ = base * static_cast<double>(samples_->size());
        samples_->raise(std::vector<std::uint32_t>(samples_->size(), base), pace());
        prediction_.score(*samples_);
        const OffAllocation wanted =
            allocation_for(*samples_, prediction_, goal_.threshold(), goal_.share / 2, most_rays_);
        if (wanted.share <= goal_.share / 2) return;
        throw Unreachable(
            fmt::format("at most {:g} % off by more than {:g} steps needs more than {} rays per "
                        "pixel in this {}; about {:.2g} % can be reached",
                        100 * goal_.share, goal_.steps, goal_.most_rays_per_pixel,
                        goal_.rows ? "part" : "scene", 200 * wanted.share));
    }

    bool refine_to(double share) {
        expected_ =
            allocation_for(*samples_, prediction_, goal_.threshold(), share, most_rays_).rays;
        return refine_off(*samples_, prediction_, goal_.threshold(), share,
                          static_cast<std::uint64_t>(most_rays_), pace());
    }

    /// An audit. `calm` is a factor on the draws from calm pixels.
    OffCount counted(double calm, RayCounts& rays) {
        PixelKinds kinds =
            kinds_of(*samples_, prediction_, goal_.threshold(), calm_share * goal_.share);
        const double pixels = static_cast<double>(samples_->size());
        const auto draws = [&](double of_all, std::size_t of_kind) {
            return static_cast<std::uint64_t>(
                std::ceil(of_all * draws_ * static_cast<double>(of_kind) / pixels));
        };
        OffPlan plan;
        plan.calm = std::move(kinds.calm);
        plan.risky = std::move(kinds.risky);
        plan.calm_draws = draws(is_calm_ ? calm : 1, plan.calm.size());
        plan.risky_draws = draws(risky_draws, plan.risky.size());
        // A calm draw counts at least for the calm draws that the factor left out.
        plan.step = is_calm_ ? std::max(most_off(plan, pixels) + 1,
                                        static_cast<std::uint64_t>(std::ceil(1 / calm)))
                             : 1;
        plan.number = audits_++;
        plan.threshold = goal_.threshold();
        const OffCount count = count_off(truth_, *samples_, plan);
        rays += count.rays;
        if (count.calm.off > 0) is_calm_ = false;
        return count;
    }

    /// The largest number of risky draws off that still shows the goal reached, if no calm draw is
    /// off.
    std::uint64_t most_off(const OffPlan& plan, double pixels) const {
        const TwoKinds kinds{{static_cast<double>(plan.calm.size()) / pixels, plan.calm_draws},
                             {static_cast<double>(plan.risky.size()) / pixels, plan.risky_draws},
                             plan.risky_draws + 1,
                             true};
        // The result is mostly small, and large numbers take long to try: the search goes upwards.
        std::uint64_t most = 0;
        std::uint64_t above = 1;
        while (above < plan.risky_draws && upper_share(kinds, above) <= goal_.share) {
            most = above;
            above *= 2;
        }
        above = std::min(above, plan.risky_draws);
        while (above > most + 1) {
            const std::uint64_t middle = most + (above - most) / 2;
            (upper_share(kinds, middle) <= goal_.share ? most : above) = middle;
        }
        return most;
    }

    /// The largest number of draws off, of all draws, that still shows the goal reached.
    std::uint64_t most_off() const {
        const auto draws = static_cast<std::uint64_t>(draws_);
        std::uint64_t most = 0;
        while (most + 1 < draws && clopper_pearson(most + 1, draws).high <= goal_.share) ++most;
        return most;
    }

    /// Sets kappa so that the predicted share is the share that was found.
    void correct(double found) {
        const double kappa = prediction_.kappa;
        double low = 0.3 * kappa;
        double high = 4 * kappa;
        for (int step = 0; step < 30; ++step) {
            prediction_.kappa = (low + high) / 2;
            const double share = predicted_off(*samples_, prediction_, goal_.threshold());
            (share > found ? high : low) = prediction_.kappa;
        }
    }

    void decide() {
        const auto draws = static_cast<std::uint64_t>(draws_);
        const double aim = chance_of_at_most(most_off(), draws, likely);
        const double allowed = std::max(1.0, std::floor(aim * draws_));
        double earlier = 0;  // the share that the last round found
        for (int round = 0; round < most_rounds; ++round) {
            const bool refined = refine_to(aim);
            const OffCount count = counted(calm_draws_to_decide, report_.deciding);
            if (!refined || static_cast<double>(count.most()) <= allowed) return;
            const double found = share_of(count);
            // After a new beginning in the last round, nothing would refine the picture any more.
            const bool may_begin_anew = round > 0 && round + 1 < most_rounds;
            if (may_begin_anew && found > no_better * earlier && goes_deeper()) {
                earlier = 0;
                continue;
            }
            earlier = found;
            correct(found);
        }
    }

    /// Called when more samples hardly lowered the share: the limits may cut light that only an
    /// audit has met. Begins anew with the truth's limits. False when these are in use already.
    bool goes_deeper() {
        const TraceLimits whole = whole_limits(truth_, goal_.fixed);
        if (whole.max_depth == report_.limits.max_depth &&
            whole.min_contribution == report_.limits.min_contribution)
            return false;
        report_.limits = whole;
        report_.deciding += samples_->rays();
        take_samples();
        begin();
        return true;
    }

    void print() {
        report_.audited = true;
        printed_ = counted(calm_draws, report_.printed);
        report_.off->estimate = estimate(printed_);
    }

    const Renderer& renderer_;
    const Truth& truth_;
    const View view_;
    const OffGoal& goal_;
    const Progress& progress_;
    ErrorReport report_;
    std::optional<PictureSamples> samples_;
    Prediction prediction_;
    double most_rays_ = 0;
    double expected_ = 0;  ///< number of samples of the finished picture, for progress
    std::uint64_t audits_ = 0;
    double draws_ = 0;     ///< of an audit that treats all pixels alike
    bool is_calm_ = true;  ///< no audit has met a calm pixel that is off
    OffCount printed_;
};

}  // namespace

ErrorPicture render_to_share(const Renderer& renderer, const Truth& truth, const View& view,
                             const OffGoal& goal, const Progress& progress) {
    return Search(renderer, truth, view, goal, progress).run();
}

}  // namespace lancer::accuracy
