#include "cli/settings_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <thread>

#include "cli/arguments.h"
#include "cli/session.h"
#include "model/precision_names.h"

namespace lancer::cli {
namespace {

constexpr std::int64_t most_threads = 1024;
constexpr std::int64_t deepest = 1000;
constexpr std::int64_t most_samples = 1000;  // per axis

Precision parse_precision(const std::string& text) {
    for (const Precision precision : all_precisions)
        if (text == name_of(precision)) return precision;
    throw UsageError("'" + text + "' is no precision: expected single, double or extended");
}

Sampling parse_sampling(const std::string& text) {
    if (text == "grid") return Sampling::grid;
    if (text == "sobol") return Sampling::sobol;
    throw UsageError("'" + text + "' is no way of sampling: expected grid or sobol");
}

Quality parse_quality(const std::string& text) {
    if (const std::optional<Quality> quality = quality_called(text)) return *quality;
    throw UsageError("'" + text + "' is no quality: expected draft, normal, fine or exact");
}

}  // namespace

void SettingsOptions::apply_to(Settings& settings) const {
    if (threads) settings.threads = static_cast<int>(*threads);
    if (settings.threads == 0)
        settings.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    if (quality) apply(values_of(*quality), settings);
    if (max_depth) settings.max_depth = static_cast<int>(*max_depth);
    if (min_contribution) settings.min_contribution = *min_contribution;
    if (samples) settings.samples = static_cast<int>(*samples);
    if (sampling) settings.sampling = *sampling;
    if (seed) settings.seed = static_cast<std::uint64_t>(*seed);
    if (tolerance) settings.tolerance = *tolerance;
    if (precision) settings.precision = *precision;
    if (no_shadows) settings.shadows = false;
    if (no_smooth) settings.smooth = false;
    if (no_textures) settings.textures = false;
}

void add_settings_options(CLI::App& app, SettingsOptions& options) {
    const char* group = "Quality";
    add_whole_number(app, "--threads", options.threads, 1, most_threads,
                     "Threads; as many as the machine has by default. The picture is the same")
        ->type_name("N");
    app.add_option_function<std::string>(
           "--quality",
           [&options](const std::string& text) { options.quality = parse_quality(text); },
           "draft, normal, fine or exact: samples, depth and contribution at once")
        ->type_name("NAME")
        ->group(group);
    add_whole_number(app, "--max-depth", options.max_depth, 1, deepest,
                     "Levels of recursion; 1: primary rays only")
        ->type_name("N")
        ->group(group);
    add_number(app, "--min-contribution", options.min_contribution, 0,
               std::numeric_limits<double>::max(),
               "A branch whose weight falls below it is not followed; 0: all are")
        ->type_name("X")
        ->group(group);
    add_whole_number(app, "--samples", options.samples, 1, most_samples,
                     "N x N rays per pixel; 1: through its centre")
        ->type_name("N")
        ->group(group);
    app.add_option_function<std::string>(
           "--sampling",
           [&options](const std::string& text) { options.sampling = parse_sampling(text); },
           "Where those rays go: a regular grid (default), or sobol points, of which fewer do")
        ->type_name("WAY")
        ->group(group);
    add_whole_number(app, "--seed", options.seed, 0, std::numeric_limits<std::int64_t>::max(),
                     "Other sobol points; 0 by default")
        ->type_name("N")
        ->group(group);
    add_number(app, "--tolerance", options.tolerance, std::numeric_limits<double>::denorm_min(),
               std::numeric_limits<double>::max(),
               "Largest distance of a tessellated surface from the true one")
        ->type_name("X")
        ->group(group);
    app.add_option_function<std::string>(
           "--precision",
           [&options](const std::string& text) { options.precision = parse_precision(text); },
           "Number type of geometry and shading: single, double (default) or extended")
        ->type_name("TYPE")
        ->group(group);
    app.add_flag("--no-shadows", options.no_shadows, "Lights shine through everything")
        ->group(group);
    app.add_flag("--no-smooth", options.no_smooth, "Flat triangles instead of interpolated normals")
        ->group(group);
    app.add_flag("--no-textures", options.no_textures, "Plain colours instead of textures")
        ->group(group);
}

}  // namespace lancer::cli
