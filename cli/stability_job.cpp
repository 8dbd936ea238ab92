#include "cli/stability_job.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/build_identity.h"
#include "cli/memory_bound.h"
#include "cli/run_origin.h"
#include "cli/scene_size.h"
#include "cli/stopwatch.h"
#include "judge/stability/stability.h"
#include "judge/stability/stability_text.h"
#include "model/diagnostic.h"
#include "model/precision_names.h"

namespace lancer::cli {
namespace {

using judge::Change;
using judge::StabilityReport;
using judge::Trial;
using judge::Window;

/// The changes to try: all, or those of --try, over the usual or the given range; and those of
/// --require.
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
        throw UsageError(fmt::format("'{}': the name of a plot must end in .svg", job.plot));
    for (const ChangeRange& demand : job.demands) {
        if (!demand.high && base_of(demand.change) != 0)
            throw UsageError(fmt::format(
                "--require {0} needs a range, as in {0}={1}", demand.text,
                demand.change == Change::shift || demand.change == Change::distance ? "1e6"
                                                                                    : "1e-6..1e6"));
    }
}

/// A scene that is about to be tested.
struct StabilityScene {
    std::string name;
    Scene scene;
    reference::ExportView view;
    std::string content;  ///< digest
};

StabilityScene load(const std::string& path, const StabilityJob& job, Session& session) {
    SceneLoader loader(path, job.scene_options, session);
    StabilityScene loaded;
    loaded.name = path == "-" ? "standard input" : path;
    loaded.scene = loader.load();
    loaded.scene.settings.samples = 1;  // the pixel's centre, unless asked otherwise
    job.settings.apply_to(loaded.scene.settings);
    const PictureSize size = size_or(job.size, loaded.scene, 160);
    const std::uint64_t needed = 4 * picture_bytes(size.width, size.height, 3);
    if (needed > available_memory())
        throw UsageError(fmt::format("pictures of {}x{} pixels do not fit into memory", size.width,
                                     size.height));
    loaded.view = {static_cast<std::uint32_t>(pick_camera(loaded.scene, job.camera, session)),
                   size.width, size.height};
    loaded.content = loader.content();
    return loaded;
}

/// The scenes' tests, one after the other. With --part only every N-th change is tried, scene
/// after scene, POV-Ray counting as one: the others are other machines'.
class Tests {
  public:
    Tests(const StabilityJob& job, Session& session) : job_(job), session_(session) {
        if (!job.no_cache) cache_ = reference::cache_folder();
    }

    void run(const StabilityScene& loaded) {
        StabilityReport report;
        report.scene = loaded.name;
        report.precision = name_of(loaded.scene.settings.precision);
        report.width = loaded.view.width;
        report.height = loaded.view.height;
        report.options.fail = job_.fail.value_or(report.options.fail);
        report.options.fail_percent = job_.fail_percent.value_or(0);
        report.options.every = job_.every;
        judge::StabilityTest test(loaded.scene, judge::renderer_of(loaded.view), report.options,
                                  [this] { return may_go_on(); },
                                  {cache_, made_from(loaded, report.options), !!job_.part});
        const std::vector<Trial> trials = ours(trials_of(job_, loaded.scene, loaded.view.camera));
        const bool with_povray = !job_.no_povray && is_ours();
        if (trials.empty() && !with_povray) return;
        show((reports_.empty() ? "" : "\n") + stability_head(report));
        for (const Trial& trial : trials) {
            report.windows.push_back(test.run(trial));
            show(stability_row(report, report.windows.back()));
        }
        if (with_povray && may_go_on()) {
            ask_povray(job_, loaded.scene, loaded.view, job_.time.value_or(0) - watch_.seconds(),
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

    static std::string made_from(const StabilityScene& loaded,
                                 const judge::StabilityOptions& options) {
        return fmt::format("{} {} camera {} size {}x{}, {}, fail {} {}", build_identity(),
                           loaded.content, loaded.view.camera, loaded.view.width,
                           loaded.view.height, text_of(loaded.scene.settings), options.fail,
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

}  // namespace

ExitCode run_stability(const StabilityJob& job, Session& session) {
    check_names(job);
    check_share(job.part,
                !job.json.empty()   ? "--json"
                : !job.plot.empty() ? "--plot"
                                    : "",
                job.no_cache ? std::string() : reference::cache_folder());
    session.will_write(job.json, "--json");
    session.will_write(job.plot, "--plot");
    // All are read before the first is tested: a mistake in the last would come late.
    std::vector<StabilityScene> scenes;
    for (const std::string& path : job.scenes) scenes.push_back(load(path, job, session));
    Tests tests(job, session);
    for (const StabilityScene& loaded : scenes) tests.run(loaded);
    return tests.finish();
}

}  // namespace lancer::cli
