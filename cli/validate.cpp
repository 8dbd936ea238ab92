// lancer validate
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/scene_words.h"
#include "cli/validations.h"
#include "judge/report/shell_text.h"
#include "judge/validate/our_renderer.h"
#include "judge/validate/validation_text.h"

namespace lancer::cli {
namespace {

using judge::ValidationJob;

/// The scene and the options that choose its picture, as a command line.
std::string scene_words(const std::string& path, const ValidateJob& job) {
    std::string words = judge::shell_quoted(path);
    if (!job.camera.empty()) words += " --camera " + judge::shell_quoted(job.camera);
    for (const auto& [name, value] : job.scene_options.definitions)
        words += " -D " + judge::shell_quoted(name + "=" + value);
    return words;
}

ValidationJob load(const std::string& path, const ValidateJob& job, Session& session) {
    SceneLoader loader(path, job.scene_options, session);
    auto scene = std::make_shared<Scene>(loader.load());
    judge::prepare_for_validation(*scene);
    ValidationJob result;
    result.name = path == "-" ? "scene" : std::filesystem::path(path).stem().string();
    result.path = path;
    result.scene_words = scene_words(path, job);
    result.place_text = [&sources = session.sources](const SourceSpan& span) {
        return describe_place(span, sources);
    };
    const PictureSize size = size_or(job.size, *scene, 320);
    result.view = {static_cast<std::uint32_t>(pick_camera(*scene, job.camera, session)), size.width,
                   size.height};
    if (path != "-") session.files.add_input(judge::expectations_beside(path));
    if (path != "-") result.expect = judge::read_expectations(path);
    result.scene = std::move(scene);
    return result;
}

/// Puts the folder's name before scenes with the same name, which would share a line in the report.
void tell_apart(std::vector<ValidationJob>& jobs) {
    std::map<std::string, int> uses;
    for (const ValidationJob& job : jobs) ++uses[job.name];
    for (ValidationJob& job : jobs) {
        if (uses[job.name] < 2) continue;
        const std::string folder =
            std::filesystem::path(job.path).parent_path().filename().string();
        if (!folder.empty()) job.name = folder + "-" + job.name;
    }
}

/// The option that asks for a report; empty when none does.
std::string report_option(const ValidateJob& job) {
    if (!job.report.empty()) return "--report";
    if (!job.json.empty()) return "--json";
    return job.junit.empty() ? "" : "--junit";
}

OtherSide povray_side(const ValidateJob& job) {
    const reference::PovRay povray = reference::find_povray();
    reference::PovOptions options;
    options.cache = job.no_cache ? std::string() : reference::cache_folder();
    options.time_limit = job.time_limit.value_or(options.time_limit);
    return {"POV-Ray", povray.version, judge::validation_report(povray, LANCER_VERSION),
            [povray, options](const ValidationJob& scene) {
                return judge::validate_scene(scene, judge::render_ours, povray, options);
            }};
}

/// `pictures`: by the scenes' paths.
OtherSide picture_side(const ValidateJob& job, std::map<std::string, std::string> pictures) {
    return {"picture",
            {},
            judge::against_report(LANCER_VERSION, job.against.pictures, job.against.reading),
            [&job, pictures = std::move(pictures)](const ValidationJob& scene) {
                return judge::validate_against(
                    {scene, pictures.at(scene.path), job.against.reading, job.size.has_value()});
            }};
}

void check_against(const ValidateJob& job) {
    if (job.against.asked()) {
        if (job.no_cache || job.time_limit || job.part)
            throw UsageError(
                "--no-cache, --time-limit and --part are for POV-Ray, which --against does not "
                "run");
    } else if (job.against.reading_is_given) {
        throw UsageError("--encoding, --exposure and --pixel-center need --against PICTURE");
    }
}

ExitCode validate(const ValidateJob& job, Session& session) {
    check_against(job);
    const std::vector<std::string> scenes =
        share_of(job.scenes, job.part, report_option(job),
                 job.no_cache ? std::string() : reference::cache_folder());
    session.will_write(job.json, "--json");
    session.will_write(job.junit, "--junit");
    if (!job.report.empty())
        session.files.add_output_in_new_folder(job.report + "/index.html", "--report");
    // An unreadable scene does not stop the others.
    ExitCode worst = ExitCode::done;
    std::vector<ValidationJob> jobs;
    std::map<std::string, std::string> pictures;
    for (const std::string& path : scenes) {
        try {
            if (job.against.asked()) {
                pictures[path] = picture_for(job.against, path, scenes.size());
                session.files.add_input(pictures[path]);
            }
            jobs.push_back(load(path, job, session));
        } catch (const SceneRejected& rejected) {
            worst = std::max(worst, rejected.code);
        } catch (const FileError& error) {
            session.terminal.error(error.what());
            worst = std::max(worst, ExitCode::files);
        }
    }
    if (jobs.empty()) return worst;
    tell_apart(jobs);
    Validations validations(
        job, std::move(jobs),
        job.against.asked() ? picture_side(job, std::move(pictures)) : povray_side(job), session);
    validations.run();
    return std::max(worst, validations.finish());
}

}  // namespace

void add_validate(CLI::App& app, Action& action) {
    CLI::App& command = *app.add_subcommand("validate",
                                            "Render scenes with Lancer and with POV-Ray (or take "
                                            "an existing picture), and judge the differences");
    const auto job = std::make_shared<ValidateJob>();
    command
        .add_option("SCENE", job->scenes,
                    "Scene files; NAME.expect in the same folder contains a scene's thresholds")
        ->required()
        ->type_name("");
    command.add_option("--report", job->report, "Write the page DIR/index.html")->type_name("DIR");
    command.add_option("--json", job->json, "Write the results as JSON; - to standard output")
        ->type_name("FILE");
    command
        .add_option("--junit", job->junit,
                    "Write the results as JUnit XML, for build servers; - to standard output")
        ->type_name("FILE");
    add_share_option(command, job->part);
    command.add_option("--camera", job->camera, "Name of the camera; by default the first one")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--size", [job](const std::string& text) { job->size = parse_size(text); },
            "Size of the pictures; by default 320 pixels wide, in the scene's proportions; with "
            "--against the size of the picture")
        ->type_name("WxH");
    add_whole_number(command, "--jobs", job->jobs, 1, 1024,
                     "Number of scenes at once; by default twice the number of cores")
        ->type_name("N");
    add_number(command, "--time-limit", job->time_limit, 1, 1e6,
               "POV-Ray is stopped after S seconds (default 120)")
        ->type_name("S");
    command.add_flag("--no-cache", job->no_cache, "Let POV-Ray render every picture again");
    command.add_flag("-q,--quiet", job->quiet, "Print no table");
    add_against_options(command, job->against);
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer validate scene.lancer --report differences"
        "\n  lancer validate scene.lancer --against other.exr");
    command.callback(
        [&action, job] { action = [job](Session& session) { return validate(*job, session); }; });
}

}  // namespace lancer::cli
