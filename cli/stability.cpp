// lancer stability
#include <CLI/CLI.hpp>

#include <memory>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/stability_job.h"

namespace lancer::cli {
namespace {

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
                     "Try only this change: scale=A..B, twos=A..B, shift=B, distance=B, axes or "
                     "extended; can be repeated");
    add_range_option(command, "--require", job->demands,
                     "Exit code 1 unless this holds, as in scale=1e-6..1e6; can be repeated");
    command.add_flag(
        "--every", job->every,
        "Try every power in the range, not only those that are needed to find its end");
    add_number(command, "--fail", job->fail, 0, 1,
               "A pixel is wrong when a channel is off by more than X (default 1/255)")
        ->type_name("X");
    add_number(command, "--fail-percent", job->fail_percent, 0, 100,
               "A picture is wrong when more than P percent of its pixels are (default 0)")
        ->type_name("P");
    add_number(command, "--time", job->time, 0.1, 1e6,
               "Start no new picture after S seconds; what is not known then stays open")
        ->type_name("S");
    command
        .add_option("--json", job->json,
                    "Write everything, also of each picture, as JSON; - to standard output")
        ->type_name("FILE");
    command.add_option("--plot", job->plot, "Plot the share of wrong pixels against the change")
        ->type_name("FILE.svg");
    command.add_option("--camera", job->camera, "Name of the camera; by default the first one")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--size", [job](const std::string& text) { job->size = parse_size(text); },
            "Size of the pictures; by default 160 pixels wide, in the scene's proportions")
        ->type_name("WxH");
    add_share_option(command, job->part, "change");
    command.add_flag("--no-povray", job->no_povray, "Do not run POV-Ray, even if it is installed");
    command.add_flag("--no-cache", job->no_cache, "Render every picture again");
    command.add_flag("-q,--quiet", job->quiet,
                     "Print nothing: only the exit code tells the result");
    add_settings_options(command, job->settings);
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer stability scene.lancer --require scale=1e-6..1e6");
    command.callback([&action, job] {
        action = [job](Session& session) { return run_stability(*job, session); };
    });
}

}  // namespace lancer::cli
