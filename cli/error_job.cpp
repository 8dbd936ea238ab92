#include "cli/error_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "accuracy/error_target.h"
#include "accuracy/off_target.h"
#include "accuracy/passes.h"
#include "cli/session.h"
#include "cli/stopwatch.h"

namespace lancer::cli {
namespace {

/// The settings of the truth. It is compiled for the deepest recursion that any trace may need;
/// each trace limits its own.
Settings true_settings(const Scene& scene, const Settings& wanted, double error) {
    Settings settings = scene.settings;
    const TraceLimits limits = accuracy::limits_of_truth(error);
    settings.max_depth = std::max(limits.max_depth, wanted.max_depth);
    settings.min_contribution = limits.min_contribution;
    settings.tolerance = std::nullopt;
    settings.samples = 1;
    settings.threads = wanted.threads;
    settings.precision =
        wanted.precision == Precision::extended ? Precision::extended : Precision::double_;
    return settings;
}

/// Whether the picture leaves out something else than branches of its recursion.
bool leaves_out(const Settings& picture, const Settings& truth) {
    return picture.shadows != truth.shadows || picture.smooth != truth.smooth ||
           picture.textures != truth.textures || picture.tolerance != truth.tolerance ||
           picture.precision != truth.precision;
}

/// Adds the channels of plain rendering, then those of adaptive sampling.
void add_channels(Image& image, const Image& plain, const accuracy::ErrorPicture& made) {
    const int extra = plain.channels - 3;
    Image whole(image.width, image.height, plain.channels + 2);
    whole.extra_names = plain.extra_names;
    whole.extra_names.insert(whole.extra_names.end(), {"error.Y", "samples.Z"});
    std::size_t pixel = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x, ++pixel) {
            double* out = std::copy_n(image.pixel(x, y), 3, whole.pixel(x, y));
            out = std::copy_n(plain.pixel(x, y) + 3, extra, out);
            *out++ = made.errors[pixel];
            *out = made.counts[pixel];
        }
    }
    image = std::move(whole);
}

/// One sample a pixel, as in every picture; its rays are not counted. The strips of `rows` are
/// stacked without gaps.
Image plain_picture(const Renderer& renderer, const View& view,
                    const std::optional<accuracy::PictureRows>& rows) {
    RayCounts uncounted;
    if (!rows) return renderer.render(view, {}, uncounted);
    const Crop whole = view.crop.value_or(Crop{0, 0, view.width, view.height});
    Image all;
    for (const accuracy::RowRange& range : rows->ranges) {
        View strip = view;
        strip.crop = Crop{whole.x, whole.y + range.first, whole.width, range.count};
        Image image = renderer.render(strip, {}, uncounted);
        if (all.height == 0) {
            all = std::move(image);
            continue;
        }
        all.height += image.height;
        all.data.insert(all.data.end(), image.data.begin(), image.data.end());
    }
    return all;
}

/// The world of the picture and that of the truth.
struct Setting {
    Setting(const Scene& scene, const SettingsOptions& options, double error, Level level) {
        const Stopwatch watch;
        Settings wanted = scene.settings;
        options.apply_to(wanted);
        const Settings truth = true_settings(scene, wanted, error);
        Settings picture = wanted;
        picture.samples = 1;
        picture.max_depth = truth.max_depth;
        picture.min_contribution = truth.min_contribution;
        seed = wanted.seed;
        if (options.max_depth) fixed.max_depth = wanted.max_depth;
        if (options.min_contribution) fixed.min_contribution = wanted.min_contribution;
        judge = compile(scene, truth, level);
        if (leaves_out(picture, truth)) other = compile(scene, picture, level);
        build_seconds = watch.seconds();
    }

    const Renderer& renderer() const { return other ? *other : *judge; }
    accuracy::Truth truth(double error) const { return {*judge, accuracy::limits_of_truth(error)}; }
    ErrorRun run(accuracy::ErrorPicture made, const View& view,
                 const std::optional<accuracy::PictureRows>& rows) const {
        ErrorRun run;
        run.build_seconds = build_seconds;
        run.image = std::move(made.image);
        run.report = made.report;
        run.sums = made.sums;
        if (view.aov) add_channels(run.image, plain_picture(renderer(), view, rows), made);
        run.world = renderer().counts();
        run.level = renderer().level();
        return run;
    }

    std::unique_ptr<Renderer> judge;
    std::unique_ptr<Renderer> other;  ///< the picture's own, if it leaves out more than limits do
    accuracy::FixedLimits fixed;
    std::uint64_t seed = 0;
    double build_seconds = 0;
};

/// Decides whether there is time for one more pass. The clock decides only how many passes there
/// are.
class PassPace {
  public:
    PassPace(const ErrorOptions& options, const PassClock& clock)
        : options_(options), clock_(clock), last_(clock.seconds()) {}

    bool go_on(const accuracy::PassState& state) {
        const double now = clock_.seconds();
        if (state.rays > rays_) {
            // The scattered rays before the first pass cost more each.
            if (state.passes == 1) count_ = 0, measured_ = 0, measured_seconds_ = 0;
            measured_ += state.rays - rays_;
            measured_seconds_ += now - last_;
            rates_[count_++ % rates_.size()] =
                (now - last_) / static_cast<double>(state.rays - rays_);
        }
        rays_ = state.rays;
        if (state.passes > 0) show(state, now);
        last_ = clock_.seconds();
        if (options_.passes) return state.passes < *options_.passes;
        const double needed =
            per_ray() * static_cast<double>(state.next + state.audits) + show_seconds_;
        if (state.passes == 0) check(needed);
        return last_ + needed <= *options_.seconds;
    }

  private:
    /// Seconds: the median of the last passes, which go where rays cost more, but not much more
    /// than the mean of all. A pass that had to wait for the processor says little about the next.
    double per_ray() const {
        if (count_ == 0) return 0;
        std::array<double, 5> sorted = rates_;
        const auto end =
            sorted.begin() + static_cast<std::ptrdiff_t>(std::min(count_, sorted.size()));
        const auto middle = sorted.begin() + (end - sorted.begin()) / 2;
        std::nth_element(sorted.begin(), middle, end);
        return std::min(*middle, 1.5 * measured_seconds_ / static_cast<double>(measured_));
    }

    /// A few scattered rays cost more each than those of a picture, so only a clearly too short
    /// time is refused.
    void check(double needed) const {
        if (last_ + needed / 3 <= *options_.seconds) return;
        throw UsageError(fmt::format(
            "--time {:g} is too short for one ray per pixel and {}: that takes about {:.2g} s",
            *options_.seconds, options_.no_audit ? "the file" : "an audit", last_ + needed));
    }

    /// Shows the picture after the first pass, and whenever the time has doubled.
    void show(const accuracy::PassState& state, double now) {
        if (state.passes > 1 && now < next_show_) return;
        clock_.show(state.samples.image());
        show_seconds_ = clock_.seconds() - now;
        next_show_ = std::max(2 * now, now + 20 * show_seconds_);
    }

    const ErrorOptions& options_;
    const PassClock& clock_;
    double last_;
    std::uint64_t rays_ = 0;
    std::array<double, 5> rates_{};  ///< seconds per ray of the last passes, in no order
    std::size_t count_ = 0;          ///< passes measured
    std::uint64_t measured_ = 0;     ///< their rays
    double measured_seconds_ = 0;
    double next_show_ = 0;
    double show_seconds_ = 0;
};

}  // namespace

ErrorRun render_to_error(const Scene& scene, const SettingsOptions& options,
                         const ErrorOptions& errors, Level level, const View& view,
                         const std::optional<accuracy::PictureRows>& rows,
                         const Progress& progress) {
    const double error = errors.max_error.value();
    const Setting setting(scene, options, error, level);
    accuracy::ErrorGoal goal;
    goal.max_error = error;
    goal.seed = setting.seed;
    goal.audited = !errors.no_audit;
    goal.leaves_out = setting.other != nullptr;
    goal.fixed = setting.fixed;
    goal.rows = rows;
    try {
        return setting.run(accuracy::render_to_error(setting.renderer(), setting.truth(error), view,
                                                     goal, progress),
                           view, rows);
    } catch (const accuracy::Unreachable& refused) {
        throw UsageError(std::string("--max-error: ") + refused.what());
    }
}

ErrorRun render_to_share(const Scene& scene, const SettingsOptions& options,
                         const ErrorOptions& errors, Level level, const View& view,
                         const std::optional<accuracy::PictureRows>& rows,
                         const Progress& progress) {
    accuracy::OffGoal goal;
    goal.share = errors.max_off.value().share;
    goal.steps = errors.max_off.value().steps;
    const Setting setting(scene, options, goal.threshold(), level);
    goal.seed = setting.seed;
    goal.audited = !errors.no_audit;
    goal.leaves_out = setting.other != nullptr;
    goal.fixed = setting.fixed;
    goal.rows = rows;
    try {
        const accuracy::Truth truth = setting.truth(goal.threshold());
        return setting.run(
            accuracy::render_to_share(setting.renderer(), truth, view, goal, progress), view, rows);
    } catch (const accuracy::Unreachable& refused) {
        throw UsageError(std::string("--max-off: ") + refused.what());
    }
}

ErrorRun render_by_passes(const Scene& scene, const SettingsOptions& options,
                          const ErrorOptions& errors, Level level, const View& view,
                          const PassClock& clock) {
    constexpr double error = 0.001;  // the truth's limits may cut a hundredth of it
    const Setting setting(scene, options, error, level);
    accuracy::PassGoal goal;
    goal.seed = setting.seed;
    goal.audited = !errors.no_audit;
    goal.fixed = setting.fixed;
    PassPace pace(errors, clock);
    return setting.run(
        accuracy::render_by_passes(setting.renderer(), setting.truth(error), view, goal,
                                   [&](const accuracy::PassState& s) { return pace.go_on(s); }),
        view, std::nullopt);
}

}  // namespace lancer::cli
