#include "accuracy/off_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/binomial.h"
#include "accuracy/off_allocation.h"

namespace lancer::accuracy {
namespace {

constexpr std::uint32_t base = 2;  // samples a pixel: one alone says nothing of its error
constexpr int most_rounds = 6;
constexpr double draws_by_share = 12;  // of an audit: about as many of its draws may be off
constexpr int fewest_draws = 400;
constexpr double no_better = 0.8;  // of a share, after a round that should have mended more
constexpr double likely = 0.977;   // that the printed audit says what the deciding one promises

class Search {
  public:
    Search(const Renderer& renderer, const Truth& truth, const View& view, const OffGoal& goal,
           const Progress& progress)
        : renderer_(renderer), truth_(truth), view_(view), goal_(goal), progress_(progress) {
        draws_ = std::max(fewest_draws, static_cast<int>(std::ceil(draws_by_share / goal.share)));
        report_.off.emplace();
        report_.off->asked = goal.share;
        report_.off->steps = goal.steps;
        // By Chebyshev's inequality no more than a tenth of the share is off by half the threshold
        // where the mean square over channels is this.
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

    /// Parts of different sizes draw as many for each pixel.
    void share_draws() {
        if (!goal_.rows) return;
        const double rows = view_.crop ? view_.crop->height : view_.height;
        draws_ =
            static_cast<int>(std::ceil(draws_ * goal_.rows->parts * (samples_->height() / rows)));
    }

    /// What the user has fixed may put more pixels off than all that are allowed.
    void check_settings() {
        if (!goal_.leaves_out && !goal_.fixed.max_depth && !goal_.fixed.min_contribution) return;
        const OffCount count = count_left_out(truth_, renderer_, report_.limits, *samples_,
                                              {draws_, audits_++, goal_.threshold()});
        report_.deciding += count.rays;
        const OffEstimate left_out = estimate(count);
        if (left_out.low <= goal_.share) return;
        throw Unreachable(fmt::format(
            "at most {:g} % off by more than {:g} steps cannot be reached with these settings: "
            "what they leave out puts {:.2g} % off by itself",
            100 * goal_.share, goal_.steps, 100 * left_out.share));
    }

    void begin() {
        expected_ = base * static_cast<double>(samples_->size());
        samples_->raise(std::vector<std::uint32_t>(samples_->size(), base), pace());
        prediction_.score(*samples_);
        const OffAllocation wanted =
            allocation_for(*samples_, prediction_, goal_.threshold(), goal_.share / 2, most_rays_);
        if (wanted.share <= goal_.share / 2) return;
        throw Unreachable(fmt::format(
            "at most {:g} % off by more than {:g} steps needs more than {} rays a pixel in this "
            "{}; about {:.2g} % can be reached",
            100 * goal_.share, goal_.steps, goal_.most_rays_per_pixel,
            goal_.rows ? "part" : "scene", 200 * wanted.share));
    }

    bool refine_to(double share) {
        expected_ =
            allocation_for(*samples_, prediction_, goal_.threshold(), share, most_rays_).rays;
        return refine_off(*samples_, prediction_, goal_.threshold(), share,
                          static_cast<std::uint64_t>(most_rays_), pace());
    }

    OffCount counted(RayCounts& rays) {
        const OffCount count = count_off(truth_, *samples_, {draws_, audits_++, goal_.threshold()});
        rays += count.rays;
        return count;
    }

    /// So many draws may be off when an audit is to say that the goal is held.
    std::uint64_t most_off() const {
        const auto draws = static_cast<std::uint64_t>(draws_);
        std::uint64_t most = 0;
        while (most + 1 < draws && clopper_pearson(most + 1, draws).high <= goal_.share) ++most;
        return most;
    }

    /// What was predicted takes the share that was found.
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
        double earlier = 0;  // share that the last round found
        for (int round = 0; round < most_rounds; ++round) {
            const bool refined = refine_to(aim);
            const OffCount count = counted(report_.deciding);
            if (!refined || static_cast<double>(count.off + count.undecided) <= allowed) return;
            const double found = estimate(count).share;
            if (round > 0 && found > no_better * earlier && goes_deeper()) {
                earlier = 0;
                continue;
            }
            earlier = found;
            correct(found);
        }
    }

    /// More samples brought little: limits may cut what only an audit has met. Begins anew with the
    /// truth's. False when they are those already.
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
        printed_ = counted(report_.printed);
        report_.off->estimate = estimate(printed_);
    }

    const Renderer& renderer_;
    const Truth& truth_;
    const View view_;
    const OffGoal& goal_;
    const Progress& progress_;
    ErrorReport report_;
    std::optional<Samples> samples_;
    Prediction prediction_;
    double most_rays_ = 0;
    double expected_ = 0;  ///< samples of the whole picture, for progress
    std::uint64_t audits_ = 0;
    int draws_ = 0;
    OffCount printed_;
};

}  // namespace

ErrorPicture render_to_share(const Renderer& renderer, const Truth& truth, const View& view,
                             const OffGoal& goal, const Progress& progress) {
    return Search(renderer, truth, view, goal, progress).run();
}

}  // namespace lancer::accuracy
