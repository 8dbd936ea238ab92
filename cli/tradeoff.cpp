// lancer tradeoff
#include "judge/tradeoff/tradeoff.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <limits>
#include <memory>

#include "cli/arguments.h"
#include "cli/build_identity.h"
#include "cli/commands.h"
#include "cli/memory_bound.h"
#include "cli/progress.h"
#include "cli/scene_loader.h"
#include "cli/scene_size.h"
#include "cli/settings_options.h"
#include "cli/stopwatch.h"
#include "cli/sweep_share.h"
#include "judge/tradeoff/page.h"
#include "judge/tradeoff/tradeoff_text.h"
#include "model/diagnostic.h"
#include "model/io/file.h"
#include "reference/povray/runner.h"

namespace lancer::cli {
namespace {

using judge::TradeOffReport;

struct TradeOffJob {
    std::vector<std::string> scenes;
    std::string json;
    std::string report;  ///< a folder; empty: none
    std::string camera;
    std::optional<PartOf> part;  ///< of the scenes
    std::optional<PictureSize> size;
    std::optional<Crop> crop;
    std::optional<double> budget;
    bool no_cache = false;
    bool quiet = false;
    SettingsOptions settings;  ///< only threads and seed
    SceneOptions scene_options;
};

/// A scene that is about to be measured.
struct TradeOffScene {
    std::string name;
    Scene scene;
    View view;
    std::string content;  ///< digest
};

TradeOffScene load(const std::string& path, const TradeOffJob& job, Session& session) {
    SceneLoader loader(path, job.scene_options, session, job.settings.reading_threads());
    TradeOffScene loaded;
    loaded.name = path == "-" ? "standard input" : path;
    loaded.scene = loader.load();
    session.terminal.show(missing_parts(loaded.scene), session.sources);
    job.settings.apply_to(loaded.scene.settings);
    loaded.content = loader.content();
    const PictureSize size = size_or(job.size, loaded.scene, 160);
    View& view = loaded.view;
    view.camera = pick_camera(loaded.scene, job.camera, session);
    view.width = size.width;
    view.height = size.height;
    view.crop = job.crop;
    if (job.crop) check_crop(*job.crop, view.width, view.height);
    constexpr int at_once = 10;  // the pictures, the halves of the truth, adaptive samples
    const Crop part = view.crop.value_or(Crop{0, 0, view.width, view.height});
    if (at_once * picture_bytes(part.width, part.height, 3) > available_memory())
        throw UsageError(fmt::format("pictures of {}x{} pixels do not fit into memory", part.width,
                                     part.height));
    return loaded;
}

class TradeOffs {
  public:
    TradeOffs(const TradeOffJob& job, std::vector<TradeOffScene> scenes, Session& session)
        : job_(job),
          session_(session),
          scenes_(std::move(scenes)),
          bar_(session.terminal, job.quiet, scenes_.size()) {
        if (!job.no_cache) cache_ = reference::cache_folder();
    }

    void run() {
        for (std::size_t i = 0; i < scenes_.size(); ++i) {
            bar_.begin_part(i);
            reports_.push_back(measured(scenes_[i], scenes_.size() - i));
            bar_.clear();
            if (!job_.quiet)
                session_.output.say((i > 0 ? "\n" : "") + judge::tradeoff_text(reports_.back()));
        }
        session_.write(job_.json, judge::tradeoff_json(reports_));
        if (job_.report.empty()) return;
        judge::write_tradeoff(std::move(reports_), job_.report);
        if (!job_.quiet) session_.output.say(fmt::format("wrote {}/index.html\n", job_.report));
    }

  private:
    TradeOffReport measured(const TradeOffScene& loaded, std::size_t left) {
        judge::TradeOffOptions options;
        // The remaining scenes share the time that is left.
        if (job_.budget)
            options.budget =
                std::max(1e-3, *job_.budget - watch_.seconds()) / static_cast<double>(left);
        options.with_pictures = !job_.report.empty();
        options.cache = {cache_, std::string(build_identity()) + loaded.content};
        options.progress = [this](double share, const std::string& what) {
            bar_.set_label(what);
            bar_.update(share);
        };
        try {
            TradeOffReport report = judge::trade_off(loaded.scene, loaded.view, options);
            report.scene = loaded.name;
            return report;
        } catch (const judge::BudgetTooShort& error) {
            throw UsageError(fmt::format("--budget {:g} is too short for {}: {}", *job_.budget,
                                         loaded.name, error.what()));
        }
    }

    const TradeOffJob& job_;
    Session& session_;
    std::vector<TradeOffScene> scenes_;
    Stopwatch watch_;
    std::string cache_;
    std::vector<TradeOffReport> reports_;
    ProgressBar bar_;
};

/// An existing file must belong to an earlier report.
void will_report(const TradeOffJob& job, Session& session) {
    if (job.report.empty()) return;
    std::vector<std::string> names = judge::plot_names(job.scenes);
    names.insert(names.begin(), "index.html");
    for (const std::string& name : names) {
        const std::string path = job.report + "/" + name;
        session.files.add_output_in_new_folder(path, "--report " + name);
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) continue;
        if (io::read_file(path).find(judge::tradeoff_mark) == std::string::npos)
            throw UsageError(fmt::format(
                "--report: '{}' exists and is not an earlier report: it would be lost", path));
    }
}

ExitCode tradeoff(const TradeOffJob& job, Session& session) {
    const std::vector<std::string> scenes =
        share_of(job.scenes, job.part,
                 !job.report.empty() ? "--report"
                 : job.json.empty()  ? ""
                                     : "--json",
                 job.no_cache ? std::string() : reference::cache_folder());
    session.will_write(job.json, "--json");
    will_report(job, session);
    // All are read before the first is measured: a mistake in the last would come late.
    std::vector<TradeOffScene> loaded;
    for (const std::string& path : scenes) loaded.push_back(load(path, job, session));
    TradeOffs(job, std::move(loaded), session).run();
    return ExitCode::done;
}

void add_view_options(CLI::App& command, const std::shared_ptr<TradeOffJob>& job) {
    command.add_option("--camera", job->camera, "Name of the camera; by default the first one")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--size", [job = job.get()](const std::string& text) { job->size = parse_size(text); },
            "Size of the pictures; by default 160 pixels wide, in the scene's proportions")
        ->type_name("WxH");
    command
        .add_option_function<std::string>(
            "--crop", [job = job.get()](const std::string& text) { job->crop = parse_crop(text); },
            "Render only this part of the picture, in pixels from its top left corner")
        ->type_name("X,Y,W,H");
    add_whole_number(
        command, "--threads", job->settings.threads, 1, 1024,
        "Number of threads; by default as many as the machine has. Times are sums over all of them")
        ->type_name("N");
    add_whole_number(command, "--seed", job->settings.seed, 0,
                     std::numeric_limits<std::int64_t>::max(),
                     "Seed of the Sobol points; by default 0")
        ->type_name("N");
}

}  // namespace

void add_tradeoff(CLI::App& app, Action& action) {
    CLI::App& command = *app.add_subcommand(
        "tradeoff", "Vary each setting of quality, and measure what it costs and what it gains");
    const auto job = std::make_shared<TradeOffJob>();
    command.add_option("SCENE", job->scenes, "Scene files; - reads standard input")
        ->required()
        ->type_name("");
    command.add_option("--json", job->json, "Write everything as JSON; - to standard output")
        ->type_name("FILE");
    command
        .add_option("--report", job->report,
                    "Write DIR/index.html with interactive plots, and these as SVG")
        ->type_name("DIR");
    add_number(command, "--budget", job->budget, 0.1, 1e7,
               "Finish within S seconds; what is left out is listed")
        ->type_name("S");
    add_share_option(command, job->part);
    add_view_options(command, job);
    command.add_flag("--no-cache", job->no_cache, "Compute the truth again, and do not keep it");
    command.add_flag("-q,--quiet", job->quiet, "Print no table");
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer tradeoff scene.lancer --report costs");
    command.callback(
        [&action, job] { action = [job](Session& session) { return tradeoff(*job, session); }; });
}

}  // namespace lancer::cli
