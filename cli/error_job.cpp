#include "cli/error_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/session.h"
#include "cli/stopwatch.h"

namespace lancer::cli {
namespace {

/// What the picture is judged by. The deepest recursion that anything may ask for is compiled in;
/// each trace says how much of it is used.
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

/// What a picture may leave out beside branches of its recursion.
bool leaves_out(const Settings& picture, const Settings& truth) {
    return picture.shadows != truth.shadows || picture.smooth != truth.smooth ||
           picture.textures != truth.textures || picture.tolerance != truth.tolerance ||
           picture.precision != truth.precision;
}

/// The channels that plain rendering adds, then what adaptive sampling knows of each pixel.
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

std::string places(const std::vector<accuracy::PixelShare>& pixels) {
    std::string text;
    for (const accuracy::PixelShare& p : pixels)
        text +=
            fmt::format("{}{},{} ({:.0f} %)", text.empty() ? "" : ", ", p.x, p.y, 100 * p.share);
    return text;
}

std::string cost(const accuracy::ErrorReport& r) {
    return fmt::format("{:.3g} rays a pixel; as many in each would take about {:.2g}",
                       r.rays_per_pixel, std::max(r.even_rays_per_pixel, r.rays_per_pixel));
}

}  // namespace

ErrorRun render_to_error(const Scene& scene, const SettingsOptions& options,
                         const ErrorOptions& errors, Level level, const View& view,
                         const Progress& progress) {
    const double error = errors.max_error.value();
    Settings wanted = scene.settings;
    options.apply_to(wanted);
    const Settings truth = true_settings(scene, wanted, error);
    Settings picture = wanted;
    picture.samples = 1;
    picture.max_depth = truth.max_depth;
    picture.min_contribution = truth.min_contribution;

    ErrorRun run;
    Stopwatch watch;
    accuracy::ErrorGoal goal;
    goal.max_error = error;
    goal.seed = wanted.seed;
    goal.audited = !errors.no_audit;
    goal.leaves_out = leaves_out(picture, truth);
    if (options.max_depth) goal.fixed.max_depth = wanted.max_depth;
    if (options.min_contribution) goal.fixed.min_contribution = wanted.min_contribution;
    const std::unique_ptr<Renderer> judge = compile(scene, truth, level);
    std::unique_ptr<Renderer> other;
    if (goal.leaves_out) other = compile(scene, picture, level);
    const Renderer& renderer = other ? *other : *judge;
    run.build_seconds = watch.seconds();
    try {
        accuracy::ErrorPicture made = accuracy::render_to_error(
            renderer, {*judge, accuracy::limits_of_truth(error)}, view, goal, progress);
        run.image = std::move(made.image);
        run.report = made.report;
        if (view.aov) {
            RayCounts uncounted;  // as for every picture
            add_channels(run.image, renderer.render(view, {}, uncounted), made);
        }
    } catch (const accuracy::Unreachable& refused) {
        throw UsageError(std::string("--max-error: ") + refused.what());
    }
    run.world = renderer.counts();
    run.level = renderer.level();
    return run;
}

std::string error_line(const accuracy::ErrorReport& r) {
    const accuracy::ErrorEstimate& e = r.error;
    const std::string asked = fmt::format("asked {:.3g}; {}", r.asked, cost(r));
    if (!r.audited)
        return fmt::format("RMSE about {:.2g} by its own samples, not audited, {}", r.predicted,
                           asked);
    if (r.rare_light) {
        return fmt::format(
            "the error cannot be told: single rays met light unlike all around it, and may have "
            "missed more; pixels {}; {}",
            places(r.dominant), asked);
    }
    if (r.is_flat())
        return fmt::format("no error was found by {} rays of an audit, {}", r.printed.primary,
                           asked);
    if (e.all_zero) {
        return fmt::format(
            "the error cannot be told: {} rays of an audit found none, but the picture's own "
            "samples differ; {}",
            r.printed.primary, asked);
    }
    if (!r.is_told) {
        return fmt::format(
            "the error cannot be told: a few pixels carry what an audit found ({:.0f} draws would "
            "tell as much); most of it in {}; {}",
            r.effective_draws, places(r.dominant), asked);
    }
    return fmt::format("RMSE {:.2g} ({:.2g} to {:.2g}; {:.1f} steps of 8 bits), {}", e.rmse, e.low,
                       e.high, 255 * e.rmse, asked);
}

std::vector<std::pair<std::string, std::string>> error_notes(const accuracy::ErrorReport& r) {
    const accuracy::ErrorEstimate& e = r.error;
    std::vector<std::pair<std::string, std::string>> notes;
    notes.emplace_back("error.asked", fmt::format("{:.6g}", r.asked));
    if (r.audited && r.is_told) {
        notes.emplace_back("error.rmse", fmt::format("{:.6g}", e.rmse));
        notes.emplace_back("error.low", fmt::format("{:.6g}", e.low));
        notes.emplace_back("error.high", fmt::format("{:.6g}", e.high));
    }
    notes.emplace_back("rays.per_pixel", fmt::format("{:.6g}", r.rays_per_pixel));
    return notes;
}

}  // namespace lancer::cli
