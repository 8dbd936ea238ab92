// lancer stability
#include "judge/stability/stability.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/memory_bound.h"
#include "cli/scene_loader.h"
#include "cli/scene_size.h"
#include "cli/settings_options.h"
#include "cli/stability_options.h"
#include "cli/stopwatch.h"
#include "judge/stability/stability_text.h"
#include "model/diagnostic.h"
#include "model/precision_names.h"

namespace lancer::cli {
namespace {

using judge::Change;
using judge::StabilityReport;
using judge::Trial;
using judge::Window;

struct StabilityJob {
    std::string scene;
    std::string camera;
    std::string json;
    std::string plot;
    std::optional<PictureSize> size;
    std::vector<ChangeRange> tries;
    std::vector<ChangeRange> demands;
    std::optional<double> fail;
    std::optional<double> fail_percent;
    std::optional<double> time;
    bool every = false;
    bool no_povray = false;
    bool no_cache = false;
    bool quiet = false;
    SettingsOptions settings;
    SceneOptions scene_options;
};

/// What to try: all changes or those of --try, as far as is usual or asked for; and what is
/// demanded.
std::vector<Trial> trials_of(const StabilityJob& job, const Scene& scene, std::uint32_t camera) {
    std::vector<Trial> trials;
    const auto trial_of = [&](Change change) -> Trial& {
        for (Trial& trial : trials)
            if (trial.change == change) return trial;
        return trials.emplace_back(judge::default_trial(scene, camera, change));
    };
    if (job.tries.empty())
        for (const Change change : judge::all_changes) trial_of(change);
    for (const ChangeRange& range : job.tries) {
        Trial& trial = trial_of(range.change);
        trial.high = range.high.value_or(trial.high);
        trial.low = range.low.value_or(std::min(trial.low, trial.high));
    }
    for (const ChangeRange& range : job.demands) {
        Trial& trial = trial_of(range.change);
        if (!range.high) continue;
        trial.high = std::max(trial.high, *range.high);
        trial.low = std::min({trial.low, range.low.value_or(trial.low), *range.high});
        trial.also.push_back(*range.high);
        if (range.low) trial.also.push_back(*range.low);
    }
    return trials;
}

bool is_held(const ChangeRange& demand, const Window& window) {
    if (!demand.high) return base_of(demand.change) == 0 ? window.holds() : false;
    return window.holds(demand.low.value_or(window.trial.origin()), *demand.high);
}

void ask_povray(const StabilityJob& job, const Scene& scene, const reference::ExportView& view,
                double seconds_left, StabilityReport& report) {
    judge::PovRayWindow& result = report.povray.emplace();
    try {
        reference::PovOptions options;
        options.cache = job.no_cache ? std::string() : reference::cache_folder();
        if (job.time) options.time_limit = std::clamp(seconds_left, 1.0, options.time_limit);
        result =
            judge::povray_window(scene, view, reference::find_povray(), options, report.options);
    } catch (const FileError& error) {
        result.failure = error.what();
    }
}

void check_names(const StabilityJob& job) {
    if (!job.plot.empty() && !job.plot.ends_with(".svg"))
        throw UsageError(fmt::format("'{}': the name of a plot ends in .svg", job.plot));
    for (const ChangeRange& demand : job.demands) {
        if (!demand.high && base_of(demand.change) != 0)
            throw UsageError(fmt::format(
                "--require {0}: say how far, as in {0}={1}", demand.text,
                demand.change == Change::shift || demand.change == Change::distance ? "1e6"
                                                                                    : "1e-6..1e6"));
    }
}

ExitCode stability(const StabilityJob& job, Session& session) {
    check_names(job);
    session.will_write(job.json, "--json");
    session.will_write(job.plot, "--plot");
    SceneLoader loader(job.scene, job.scene_options, session);
    Scene scene = loader.load();
    scene.settings.samples = 1;  // the pixel's centre, unless asked otherwise
    job.settings.apply_to(scene.settings);
    const PictureSize size = size_or(job.size, scene, 160);
    const std::uint64_t needed = 4 * picture_bytes(size.width, size.height, 3);
    if (needed > available_memory())
        throw UsageError(fmt::format("pictures of {}x{} pixels do not fit into memory", size.width,
                                     size.height));
    const reference::ExportView view{
        static_cast<std::uint32_t>(pick_camera(scene, job.camera, session)), size.width,
        size.height};

    StabilityReport report;
    report.scene = job.scene == "-" ? "standard input" : job.scene;
    report.precision = name_of(scene.settings.precision);
    report.width = size.width;
    report.height = size.height;
    report.options.fail = job.fail.value_or(report.options.fail);
    report.options.fail_percent = job.fail_percent.value_or(0);
    report.options.every = job.every;

    const Stopwatch watch;
    const auto may_go_on = [&] { return !job.time || watch.seconds() < *job.time; };
    const auto show = [&](const std::string& text) {
        if (!job.quiet) session.output.say(text);
    };
    judge::StabilityTest test(scene, judge::renderer_of(view), report.options, may_go_on);
    show(stability_head(report));
    for (const Trial& trial : trials_of(job, scene, view.camera)) {
        report.windows.push_back(test.run(trial));
        show(stability_row(report, report.windows.back()));
    }
    if (!job.no_povray && may_go_on()) {
        ask_povray(job, scene, view, job.time.value_or(0) - watch.seconds(), report);
        show(stability_row(report, *report.povray));
    }
    bool all_held = true;
    for (const ChangeRange& demand : job.demands) {
        const auto window =
            std::find_if(report.windows.begin(), report.windows.end(),
                         [&](const Window& w) { return w.trial.change == demand.change; });
        const bool held = is_held(demand, *window);
        report.demands.push_back({demand.text, held});
        all_held = all_held && held;
    }
    show(stability_foot(report) + "\n" + stability_sentence(report) + "\n");
    session.write(job.json, stability_json(report));
    session.write(job.plot, stability_plot(report));
    return all_held ? ExitCode::done : ExitCode::differs;
}

void add_range_option(CLI::App& command, const std::string& name, std::vector<ChangeRange>& target,
                      const std::string& help) {
    command
        .add_option_function<std::vector<std::string>>(
            name,
            [&target](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) target.push_back(parse_change_range(text));
            },
            help)
        ->type_name("CHANGE")
        ->type_size(1)
        ->allow_extra_args(false);
}

}  // namespace

void add_stability(CLI::App& app, Action& action) {
    CLI::App& command = *app.add_subcommand(
        "stability", "Find how far a scene can be scaled and moved before its picture changes");
    const auto job = std::make_shared<StabilityJob>();
    command.add_option("SCENE", job->scene, "Scene file; - reads standard input")
        ->required()
        ->type_name("");
    add_range_option(command, "--try", job->tries,
                     "Only this: scale=A..B, twos=A..B, shift=B, distance=B, axes or extended; may "
                     "stand several times");
    add_range_option(command, "--require", job->demands,
                     "Exit code 1 unless this holds, as in scale=1e-6..1e6; may stand several "
                     "times");
    command.add_flag("--every", job->every,
                     "Look at every power in the range, not only as many as finding its end takes");
    add_number(command, "--fail", job->fail, 0, 1,
               "A pixel is wrong when a channel is off by more than X (default 1/255)")
        ->type_name("X");
    add_number(command, "--fail-percent", job->fail_percent, 0, 100,
               "A picture is wrong when more than P percent of its pixels are (default 0)")
        ->type_name("P");
    add_number(command, "--time", job->time, 0.1, 1e6,
               "Begin no picture after S seconds; what is open then stays open")
        ->type_name("S");
    command
        .add_option("--json", job->json,
                    "Write everything, each picture too, as JSON; - to standard output")
        ->type_name("FILE");
    command.add_option("--plot", job->plot, "Draw wrong pixels against the change")
        ->type_name("FILE.svg");
    command.add_option("--camera", job->camera, "Name of the camera; the first by default")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--size", [job](const std::string& text) { job->size = parse_size(text); },
            "Size of the pictures; 160 pixels wide by default, in the scene's proportions")
        ->type_name("WxH");
    command.add_flag("--no-povray", job->no_povray, "Do not run POV-Ray, should it be there");
    command.add_flag("--no-cache", job->no_cache, "Have POV-Ray make every picture anew");
    command.add_flag("-q,--quiet", job->quiet, "Nothing but the exit code");
    add_settings_options(command, job->settings);
    add_scene_options(command, job->scene_options);
    command.callback(
        [&action, job] { action = [job](Session& session) { return stability(*job, session); }; });
}

}  // namespace lancer::cli
