// lancer check
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "cli/commands.h"
#include "cli/mesh_hints.h"
#include "cli/scene_loader.h"

namespace lancer::cli {
namespace {

struct CheckJob {
    std::vector<std::string> scenes;
    bool quiet = false;
    SceneOptions scene_options;
};

ExitCode check(const std::string& path, const CheckJob& job, Session& session) {
    try {
        SceneLoader loader(path, job.scene_options, session);
        loader.show_too([](const Scene& scene) {
            std::vector<Diagnostic> hints = missing_parts(scene);
            for (Diagnostic& hint : smoothed_edges(scene)) hints.push_back(std::move(hint));
            return hints;
        });
        loader.load();
    } catch (const SceneRejected& rejected) {
        return rejected.code;
    } catch (const FileError& error) {
        // The other scenes are still checked.
        session.terminal.error(error.what());
        return ExitCode::files;
    }
    if (!job.quiet) session.output.say(fmt::format("{}: no errors\n", path));
    return ExitCode::done;
}

ExitCode check_all(const CheckJob& job, Session& session) {
    ExitCode worst = ExitCode::done;
    for (const std::string& path : job.scenes) worst = std::max(worst, check(path, job, session));
    return worst;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
    CLI::App& command = *app.add_subcommand("check", "Read scenes and report every mistake");
    const auto job = std::make_shared<CheckJob>();
    command.add_option("SCENE", job->scenes, "Scene files; - reads standard input")
        ->required()
        ->type_name("");
    command.add_flag("-q,--quiet", job->quiet, "Print only mistakes and warnings");
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer check *.lancer");
    command.callback(
        [&action, job] { action = [job](Session& session) { return check_all(*job, session); }; });
}

}  // namespace lancer::cli
