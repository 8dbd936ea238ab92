#include "cli/settings_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <thread>

#include "cli/arguments.h"
#include "model/precision_names.h"

namespace lancer::cli {
namespace {

constexpr std::int64_t most_threads = 1024;
constexpr std::int64_t deepest = 1000;
constexpr std::int64_t most_samples = 1000;  // per axis

/// The names of `values`, in order.
template <class Values>
std::vector<std::string> names_of(const Values& values) {
    std::vector<std::string> names;
    for (const auto value : values) names.emplace_back(name_of(value));
    return names;
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
    add_whole_number(
        app, "--threads", options.threads, 1, most_threads,
        "Number of threads; by default as many as the machine has. The picture is the same")
        ->type_name("N");
    add_choice(
        app, "--quality", names_of(all_qualities), "quality",
        [&options](std::size_t i) { options.quality = all_qualities[i]; },
        "Sets samples, depth and contribution together")
        ->group(group);
    add_whole_number(app, "--max-depth", options.max_depth, 1, deepest,
                     "Levels of recursion; 1: primary rays only")
        ->type_name("N")
        ->group(group);
    add_number(app, "--min-contribution", options.min_contribution, 0,
               std::numeric_limits<double>::max(),
               "Rays whose weight is below X are not followed; 0: all are followed")
        ->type_name("X")
        ->group(group);
    add_whole_number(app, "--samples", options.samples, 1, most_samples,
                     "N x N rays per pixel; 1: through its centre")
        ->type_name("N")
        ->group(group);
    add_choice(
        app, "--sampling", {"grid", "sobol"}, "way of sampling",
        [&options](std::size_t i) { options.sampling = i == 0 ? Sampling::grid : Sampling::sobol; },
        "Where these rays pass through the pixel: a regular grid (default), or Sobol points, of "
        "which fewer are enough")
        ->group(group);
    add_whole_number(app, "--seed", options.seed, 0, std::numeric_limits<std::int64_t>::max(),
                     "Seed of the Sobol points; by default 0")
        ->type_name("N")
        ->group(group);
    add_number(app, "--tolerance", options.tolerance, std::numeric_limits<double>::denorm_min(),
               std::numeric_limits<double>::max(),
               "Largest distance of a tessellated surface from the true one")
        ->type_name("X")
        ->group(group);
    add_choice(
        app, "--precision", names_of(all_precisions), "precision",
        [&options](std::size_t i) { options.precision = all_precisions[i]; },
        "Number type of geometry and shading; by default double")
        ->group(group);
    app.add_flag("--no-shadows", options.no_shadows, "Lights shine through everything")
        ->group(group);
    app.add_flag("--no-smooth", options.no_smooth, "Flat triangles instead of interpolated normals")
        ->group(group);
    app.add_flag("--no-textures", options.no_textures, "Plain colours instead of textures")
        ->group(group);
}

}  // namespace lancer::cli
