// lancer stability
#include "judge/stability/stability.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/arguments.h"
#include "cli/build_identity.h"
#include "cli/commands.h"
#include "cli/memory_bound.h"
#include "cli/run_origin.h"
#include "cli/scene_loader.h"
#include "cli/scene_size.h"
#include "cli/settings_options.h"
#include "cli/stability_options.h"
#include "cli/stopwatch.h"
#include "cli/sweep_share.h"
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
    std::vector<std::string> scenes;
    std::optional<PartOf> part;  ///< of all changes of all scenes
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
    if (!job.plot.empty() && job.scenes.size() > 1)
        throw UsageError("--plot shows one scene, not several");
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

/// A scene that is about to be tested.
struct Subject {
    std::string name;
    Scene scene;
    reference::ExportView view;
    std::string content;  ///< digest
};

Subject load(const std::string& path, const StabilityJob& job, Session& session) {
    SceneLoader loader(path, job.scene_options, session);
    Subject subject;
    subject.name = path == "-" ? "standard input" : path;
    subject.scene = loader.load();
    subject.scene.settings.samples = 1;  // the pixel's centre, unless asked otherwise
    job.settings.apply_to(subject.scene.settings);
    const PictureSize size = size_or(job.size, subject.scene, 160);
    const std::uint64_t needed = 4 * picture_bytes(size.width, size.height, 3);
    if (needed > available_memory())
        throw UsageError(fmt::format("pictures of {}x{} pixels do not fit into memory", size.width,
                                     size.height));
    subject.view = {static_cast<std::uint32_t>(pick_camera(subject.scene, job.camera, session)),
                    size.width, size.height};
    subject.content = loader.content();
    return subject;
}

/// The scenes' tests, one after the other. With --part only every N-th change is tried, scene after
/// scene, POV-Ray counting as one: the others are other machines'.
class Tests {
  public:
    Tests(const StabilityJob& job, Session& session) : job_(job), session_(session) {
        if (!job.no_cache) cache_ = reference::cache_folder();
    }

    void run(const Subject& subject) {
        StabilityReport report;
        report.scene = subject.name;
        report.precision = name_of(subject.scene.settings.precision);
        report.width = subject.view.width;
        report.height = subject.view.height;
        report.options.fail = job_.fail.value_or(report.options.fail);
        report.options.fail_percent = job_.fail_percent.value_or(0);
        report.options.every = job_.every;
        judge::StabilityTest test(subject.scene, judge::renderer_of(subject.view), report.options,
                                  [this] { return may_go_on(); },
                                  {cache_, made_from(subject, report.options), !!job_.part});
        const std::vector<Trial> trials = ours(trials_of(job_, subject.scene, subject.view.camera));
        const bool with_povray = !job_.no_povray && is_ours();
        if (trials.empty() && !with_povray) return;
        show((reports_.empty() ? "" : "\n") + stability_head(report));
        for (const Trial& trial : trials) {
            report.windows.push_back(test.run(trial));
            show(stability_row(report, report.windows.back()));
        }
        if (with_povray && may_go_on()) {
            ask_povray(job_, subject.scene, subject.view, job_.time.value_or(0) - watch_.seconds(),
                       report);
            show(stability_row(report, *report.povray));
        }
        if (!job_.part) {
            judge_demands(report);
            show(stability_foot(report) + "\n" + stability_sentence(report) + "\n");
        }
        reports_.push_back(std::move(report));
    }

    ExitCode finish() {
        session_.write(job_.json, stability_json(reports_));
        if (!job_.plot.empty()) session_.write(job_.plot, stability_plot(reports_.front()));
        return all_held_ ? ExitCode::done : ExitCode::differs;
    }

  private:
    bool may_go_on() const { return !job_.time || watch_.seconds() < *job_.time; }
    std::vector<Trial> ours(std::vector<Trial> trials) {
        std::erase_if(trials, [this](const Trial&) { return !is_ours(); });
        return trials;
    }
    bool is_ours() { return !job_.part || job_.part->has(piece_++); }
    void show(const std::string& text) {
        if (!job_.quiet) session_.output.say(text);
    }

    static std::string made_from(const Subject& subject, const judge::StabilityOptions& options) {
        return fmt::format("{} {} camera {} size {}x{}, {}, fail {} {}", build_identity(),
                           subject.content, subject.view.camera, subject.view.width,
                           subject.view.height, text_of(subject.scene.settings), options.fail,
                           options.fail_percent);
    }

    void judge_demands(StabilityReport& report) {
        for (const ChangeRange& demand : job_.demands) {
            const auto window =
                std::find_if(report.windows.begin(), report.windows.end(),
                             [&](const Window& w) { return w.trial.change == demand.change; });
            const bool held = is_held(demand, *window);
            report.demands.push_back({demand.text, held});
            all_held_ = all_held_ && held;
        }
    }

    const StabilityJob& job_;
    Session& session_;
    Stopwatch watch_;
    std::string cache_;
    std::vector<StabilityReport> reports_;
    std::int64_t piece_ = 0;
    bool all_held_ = true;
};

ExitCode stability(const StabilityJob& job, Session& session) {
    check_names(job);
    check_share(job.part,
                !job.json.empty()   ? "--json"
                : !job.plot.empty() ? "--plot"
                                    : "",
                job.no_cache ? std::string() : reference::cache_folder());
    session.will_write(job.json, "--json");
    session.will_write(job.plot, "--plot");
    // All are read before the first is tested: a mistake in the last would come late.
    std::vector<Subject> subjects;
    for (const std::string& path : job.scenes) subjects.push_back(load(path, job, session));
    Tests tests(job, session);
    for (const Subject& subject : subjects) tests.run(subject);
    return tests.finish();
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
    command.add_option("SCENE", job->scenes, "Scene files; - reads standard input")
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
    add_share_option(command, job->part, "change");
    command.add_flag("--no-povray", job->no_povray, "Do not run POV-Ray, should it be there");
    command.add_flag("--no-cache", job->no_cache, "Make every picture anew");
    command.add_flag("-q,--quiet", job->quiet, "Nothing but the exit code");
    add_settings_options(command, job->settings);
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer stability scene.lancer --require scale=1e-6..1e6");
    command.callback(
        [&action, job] { action = [job](Session& session) { return stability(*job, session); }; });
}

}  // namespace lancer::cli
