// lancer render
#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/picture_options.h"
#include "cli/render_job.h"

namespace lancer::cli {
namespace {

void add_output_options(CLI::App& app, RenderJob& job) {
    const char* group = "Output";
    app.add_option_function<std::string>(
           "-o,--output",
           [&job](const std::string& name) {
               if (name.empty()) throw UsageError("-o: the name of the picture is empty");
               job.output = name;
           },
           "Picture: .png .exr .hdr .tif .tiff .jpg .jpeg .ppm; by default the scene's name with "
           ".png, in the current folder")
        ->type_name("OUT")
        ->group(group);
    add_encoding_options(app, job.image);
    app.add_flag("--aov", job.aov,
                 "Also object id, depth, normal and shadow, as channels of an EXR")
        ->group(group);
    app.add_flag("--alpha", job.alpha,
                 "Make the background transparent, also where it is seen through glass: for .png, "
                 ".tif and .exr")
        ->group(group);
    app.add_option("--stats", job.statistics,
                   "Write times and counts as JSON; - shows them as text on standard output")
        ->type_name("FILE")
        ->group(group);
    app.add_flag("-q,--quiet", job.quiet, "Print no progress bar and no closing line")
        ->group(group);
}

void add_part_options(CLI::App& app, RenderJob& job) {
    const char* group = "Many machines";
    app.add_option_function<std::string>(
           "--part", [&job](const std::string& text) { job.part = parse_part(text); },
           "Render the K-th of N parts of the picture, for `join`; of an animation, its share of "
           "the frames")
        ->type_name("K/N")
        ->group(group);
    app.add_flag("--resume", job.resume,
                 "Keep a picture that exists if it is complete and the same run would render it")
        ->group(group);
}

void add_view_options(CLI::App& app, RenderJob& job) {
    const char* group = "View";
    app.add_option("--camera", job.camera, "Name of the camera; by default the first one")
        ->type_name("NAME")
        ->group(group);
    app.add_option_function<std::string>(
           "--size", [&job](const std::string& text) { job.size = parse_size(text); },
           "Size of the picture in pixels")
        ->type_name("WxH")
        ->group(group);
    app.add_flag("--preview", job.preview,
                 "A quick look: a quarter of the width and height, one ray per pixel")
        ->group(group);
    app.add_option_function<std::string>(
           "--crop", [&job](const std::string& text) { job.crop = parse_crop(text); },
           "Render only this part of the picture, in pixels from its top left corner")
        ->type_name("X,Y,W,H")
        ->group(group);
    app.add_option_function<std::string>(
           "--frames", [&job](const std::string& text) { job.frames = parse_frames(text); },
           "An animation: `frame` runs from A to B, `time` from 0 to 1; with -o out-%04d.png")
        ->type_name("A..B")
        ->group(group);
    app.add_flag("--loop", job.loop,
                 "With --frames: `time` stays below 1, so that the first frame follows the last")
        ->group(group);
}

void add_level_option(CLI::App& app, RenderJob& job) {
    static constexpr std::array levels{Level::scalar, Level::avx2, Level::avx512};
    std::vector<std::string> names;
    for (const Level level : levels) names.emplace_back(name_of(level));
    add_choice(
        app, "--level", std::move(names), "level",
        [&job](std::size_t i) {
            if (!is_supported(levels[i]))
                throw UsageError(std::string("--level: this processor has no ") +
                                 name_of(levels[i]));
            job.level = levels[i];
        },
        "How many rays are traced side by side; by default the fastest. The picture is the same");
}

void add_error_options(CLI::App& app, RenderJob& job) {
    const char* group = "Error";
    add_number(app, "--max-error", job.error.max_error, 1e-6, 1,
               "Sample until the error (RMSE, linear light) is below E, and report it")
        ->type_name("E")
        ->group(group);
    app.add_option_function<std::string>(
           "--max-off",
           [&job](const std::string& text) { job.error.max_off = parse_off_target(text); },
           "Sample until at most P percent of the pixels are off by more than N steps of 8 bits")
        ->type_name("P%:N")
        ->group(group);
    add_number(app, "--time", job.error.seconds, 0.01, 1e6,
               "Make the best picture within S seconds, pass by pass")
        ->type_name("S")
        ->group(group);
    add_whole_number(app, "--passes", job.error.passes, 1, 1'000'000,
                     "Make this number of passes, as --time would: the picture can be repeated")
        ->type_name("K")
        ->group(group);
    app.add_flag("--bound-cut", job.bound_cut,
                 "Report how much light the limits of the recursion can have left out; --quality "
                 "exact does this, too")
        ->group(group);
    app.add_flag(
           "--no-audit", job.error.no_audit,
           "With one of these: trace no rays to check the error, and report it without an interval")
        ->group(group);
}

}  // namespace

void add_render(CLI::App& app, Action& action) {
    CLI::App& command = *app.add_subcommand("render", "Render a scene to a picture");
    const auto job = std::make_shared<RenderJob>();
    command.add_option("SCENE", job->scene, "Scene file; - reads standard input")
        ->required()
        ->type_name("");
    add_output_options(command, *job);
    add_view_options(command, *job);
    add_settings_options(command, job->settings);
    add_level_option(command, *job);
    add_error_options(command, *job);
    add_part_options(command, *job);
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer render scene.lancer"
        "\n  lancer render scene.lancer -o picture.exr --size 1280x960 --samples 3"
        "\n  lancer render scene.lancer -o frame-%04d.png --frames 1..48 --loop"
        "\n  lancer render scene.lancer --max-error 0.004");
    command.callback(
        [&action, job] { action = [job](Session& session) { return run(*job, session); }; });
}

}  // namespace lancer::cli
