#include "accuracy/error_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/allocation.h"
#include "accuracy/deciding_audits.h"
#include "accuracy/prediction.h"
#include "accuracy/rare_light.h"
#include "model/elementary.h"

namespace lancer::accuracy {
namespace {

constexpr double sampling_share = 0.9;  // of the squared error; the rest is for the limits' cuts
constexpr std::uint32_t base = 2;       // samples per pixel; a single one has no variance
// If so few rays per pixel are enough, most pixels need a single sample, and their neighbours show
// it. In a small picture single samples may all miss a rare feature, so it begins with two.
constexpr double few_rays = 1.5;
constexpr std::size_t many_pixels = std::size_t(1) << 16;
constexpr double first_aim = 4;  // the first audit is taken at this multiple of the goal's square
constexpr int most_rounds = 6;
constexpr double most_log_error = 0.3;
constexpr double no_better = 0.8;     // of the last mean square: a round that lowers it less failed
constexpr double aimed_margin = 4.3;  // refining aims lower than deciding_margin asks
class Search {
  public:
    Search(const Renderer& renderer, const Truth& truth, const View& view, const ErrorGoal& goal,
           const Progress& progress)
        : renderer_(renderer),
          truth_(truth),
          view_(view),
          goal_(goal),
          progress_(progress),
          audits_(truth, goal.max_error) {
        report_.asked = goal.max_error;
        report_.limits =
            cheapest_limits(truth, view, goal.fixed, (1 - sampling_share) * square(goal.max_error),
                            goal.seed, report_.deciding);
        check_settings(renderer);
        take_samples();
        most_rays_ = static_cast<std::uint64_t>(goal.most_rays_per_pixel *
                                                static_cast<double>(samples_->size()));
    }

    ErrorPicture run() {
        begin();
        if (goal_.audited) {
            decide();
            print();
        } else {
            refine_to(sampling_share * square(goal_.max_error) - bias_);
        }
        return finished(*samples_, prediction_, std::move(report_), std::move(sums_));
    }

  private:
    static double square(double x) { return x * x; }
    Progress pace() const {
        if (!progress_) return {};
        return [this](double) {
            progress_(std::min(
                0.99, static_cast<double>(samples_->rays().primary) / std::max(1.0, expected_)));
        };
    }

    void take_samples() {
        samples_.emplace(renderer_, view_, report_.limits, goal_.seed,
                         goal_.rows.value_or(PictureRows{}));
    }

    /// Throws if the settings that the user fixed cause a larger error than the one asked for.
    void check_settings(const Renderer& renderer) {
        if (!goal_.leaves_out && !goal_.fixed.max_depth && !goal_.fixed.min_contribution) return;
        const ErrorEstimate cut =
            bias(renderer, report_.limits, truth_, view_, goal_.seed, report_.deciding);
        bias_ = std::max(0.0, cut.mean_square);
        if (cut.mean_square - 2 * cut.standard_error > square(goal_.max_error)) {
            throw Unreachable(
                fmt::format("an error of {} cannot be reached with these settings: what they leave "
                            "out already makes an RMSE of {:.2g}",
                            goal_.max_error, cut.rmse));
        }
        bias_ = std::min(bias_, square(goal_.max_error) / 2);
    }

    void begin() {
        expected_ = base * static_cast<double>(samples_->size());
        const double target = sampling_share * square(goal_.max_error) - bias_;
        const bool may_have_one = goal_.audited && samples_->size() >= many_pixels;
        if (!may_have_one || !begin_with_one(target)) {
            samples_->raise(std::vector<std::uint32_t>(samples_->size(), base), pace());
            rare_.emplace(*samples_);
            prediction_.score(*samples_);
        }
        if (rays_for(*samples_, prediction_, target) <= goal_.most_rays_per_pixel) return;
        const double reachable =
            std::sqrt((mean_square_for(*samples_, prediction_, goal_.most_rays_per_pixel) + bias_) /
                      sampling_share);
        throw Unreachable(fmt::format(
            "an error of {} needs more than {} rays per pixel in this {}; about {:.2g} can be "
            "reached",
            goal_.max_error, goal_.most_rays_per_pixel, goal_.rows ? "part" : "scene", reachable));
    }

    /// Takes one sample per pixel. False when every pixel needs more: for the goal, or because
    /// single samples differ from their neighbours by too much.
    bool begin_with_one(double mean_square) {
        samples_->raise(std::vector<std::uint32_t>(samples_->size(), 1), pace());
        rare_.emplace(*samples_);
        prediction_.score(*samples_);
        return !is_noticed(rare_->met_alone(*samples_), goal_.max_error,
                           static_cast<double>(samples_->size())) &&
               rays_for(*samples_, prediction_, mean_square) <= few_rays;
    }

    bool refine_to(double mean_square) {
        expected_ =
            rays_for(*samples_, prediction_, mean_square) * static_cast<double>(samples_->size());
        return refine(*samples_, prediction_, mean_square, most_rays_, pace());
    }

    void correct(const ErrorEstimate& e) {
        const double predicted = prediction_.mean_square(*samples_);
        if (predicted <= 0) return;
        prediction_.kappa *= std::clamp((e.mean_square - bias_) / predicted, 0.2, 4.0);
    }

    /// The expected log_error() of an audit with `of_draws` draws, from an audit with `draws`.
    static double log_error(const ErrorEstimate& e, int draws, int of_draws) {
        if (e.mean_square <= 0) return most_log_error;
        return std::min(most_log_error, e.log_error() * std::sqrt(double(draws) / of_draws));
    }

    double aim(double log_error) const {
        return square(goal_.max_error) * elementary::exp(-aimed_margin * log_error) - bias_;
    }

    /// Larger audits cost rays, and save some: the surer they are, the nearer to the goal the
    /// picture may stop.
    int best_draws(const ErrorEstimate& first, std::uint64_t rays_of_first) const {
        const double pixels = static_cast<double>(samples_->size());
        const RayCounts& so_far = samples_->rays();
        const double per_sample =
            static_cast<double>(so_far.rays()) / static_cast<double>(so_far.primary);
        int best = 0;
        double least = 0;
        const int most = most_draws(*samples_);
        for (int draws = 1000;; draws = std::min(most, draws * 7 / 5)) {
            const bool last = draws == most;
            if (log_error(first, first_draws, draws) > told_log_error && !last) continue;
            const double target = aim(log_error(first, first_draws, draws));
            const double cost =
                (target > 0 ? rays_for(*samples_, prediction_, target) * pixels * per_sample
                            : goal_.most_rays_per_pixel * pixels) +
                2.0 * draws / first_draws * static_cast<double>(rays_of_first);
            if (best == 0 || cost < least) {
                best = draws;
                least = cost;
            }
            if (last) return best;
        }
    }

    void decide() {
        refine_to(first_aim * square(goal_.max_error));
        ErrorEstimate e = audits_.first(*samples_, prediction_, report_.deciding);
        double expected_error = 0;
        const bool is_settled = audits_.is_decided(e) && audits_.is_below(e, deciding_margin);
        if (!e.all_zero) {  // otherwise there is nothing to correct by
            correct(e);
            // An audit that is the last to decide must have drawn as the printed one will.
            if (!is_settled) audits_.learn_shares();
            audits_.set_draws(best_draws(e, audits_.last().rays.rays()));
            expected_error = log_error(e, first_draws, audits_.draws());
        }
        if (is_settled ? misses_rare_light() : !decide_by_rounds(e, expected_error)) return;
        // The draws that a told interval needs, estimated from the last audit.
        const double needed = std::max<double>(
            audits_.draws(), audits_.last_draws() * square(e.log_error() / told_log_error));
        report_.effective_draws = e.effective_draws;
        report_.dominant = dominant_pixels(audits_.last(), *samples_, 3);
        report_.is_told = e.effective_draws >= least_effective_draws &&
                          needed <= std::max(audits_.draws(), most_draws(*samples_));
        if (report_.is_told) audits_.set_draws(static_cast<int>(needed));
    }

    /// Refines and audits in turn until an audit lies below the goal. `e` is then that audit's
    /// estimate. False when an error cannot be told.
    bool decide_by_rounds(ErrorEstimate& e, double expected_error) {
        double earlier = 0;  // what the last round found
        for (int round = 0; round < most_rounds; ++round) {
            const double target = aim(expected_error);
            const bool refined = target > 0 && refine_to(target);
            if (misses_rare_light()) return false;
            e = audits_.judge(*samples_, prediction_, report_.deciding);
            expected_error = log_error(e, audits_.last_draws(), audits_.draws());
            if (!refined || audits_.is_below(e, deciding_margin)) break;
            // After a new beginning in the last round, nothing would refine the picture any more.
            const bool may_begin_anew = round > 0 && round + 1 < most_rounds;
            if (may_begin_anew && e.mean_square > no_better * earlier && cuts_too_much()) {
                earlier = 0;
                expected_error = told_log_error;  // earlier audits were dominated by few pixels
                continue;
            }
            earlier = e.mean_square;
            correct(e);
            audits_.learn_shares();
        }
        return true;
    }

    /// Called when more samples did not lower the error: the limits may cut light that only an
    /// audit has met. If they do, begins anew with the truth's limits and returns true.
    bool cuts_too_much() {
        const TraceLimits whole = whole_limits(truth_, goal_.fixed);
        if (whole.max_depth == report_.limits.max_depth &&
            whole.min_contribution == report_.limits.min_contribution)
            return false;
        const std::vector<PixelShare> worst = dominant_pixels(audits_.last(), *samples_, 20);
        if (share_cut(truth_, *samples_, report_.limits, worst, report_.deciding) < 0.3)
            return false;
        report_.limits = whole;
        report_.deciding += samples_->rays();
        take_samples();
        prediction_.kappa = std::min(Prediction().kappa, prediction_.kappa);
        begin();
        return true;
    }

    /// Whether the picture missed rare light, so that no audit can tell its error.
    bool misses_rare_light() {
        sums_.specks = rare_->missed(*samples_);
        const Crop whole = view_.crop.value_or(Crop{0, 0, view_.width, view_.height});
        if (!sums_.specks.forbid(goal_.max_error, double(whole.width) * whole.height)) return false;
        report_.rare_light = true;
        report_.dominant = sums_.specks.pixels;
        return true;
    }

    /// The audit that is printed. It is not taken where the error cannot be told. A part is the
    /// exception: its draws may be enough together with those of the other parts.
    void print() {
        report_.audited = true;
        const bool found_none = !report_.rare_light && estimate(audits_.last().terms).all_zero;
        const bool is_part_of_told = goal_.rows && !report_.rare_light;
        if (!report_.is_told && !found_none && !is_part_of_told) return;
        const Audit last = audits_.separate(*samples_, prediction_, report_.printed);
        report_.error = estimate(last.terms, audits_.last().terms);
        sums_.deciding = TermSums(audits_.last().terms);
        sums_.printed = TermSums(last.terms);
        if (!found_none) return;
        report_.effective_draws = report_.error.effective_draws;
        report_.dominant = dominant_pixels(last, *samples_, 3);
    }

    const Renderer& renderer_;
    const Truth& truth_;
    const View view_;
    const ErrorGoal& goal_;
    const Progress& progress_;
    ErrorReport report_;
    ErrorSums sums_;
    std::optional<PictureSamples> samples_;
    Prediction prediction_;
    std::optional<RareLight> rare_;
    DecidingAudits audits_;
    double bias_ = 0;  ///< mean squared error that no samples remove
    std::uint64_t most_rays_ = 0;
    double expected_ = 0;  ///< samples of the whole picture, for progress
};

}  // namespace

ErrorPicture render_to_error(const Renderer& renderer, const Truth& truth, const View& view,
                             const ErrorGoal& goal, const Progress& progress) {
    return Search(renderer, truth, view, goal, progress).run();
}

}  // namespace lancer::accuracy
