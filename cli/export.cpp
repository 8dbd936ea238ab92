// lancer export
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/scene_loader.h"
#include "model/io/file.h"
#include "reference/pov/export.h"
#include "reference/pov/signature.h"

namespace lancer::cli {
namespace {

namespace fs = std::filesystem;

struct ExportJob {
    std::string scene;
    std::string output;
    std::string camera;
    std::optional<PictureSize> size;
    std::optional<double> exposure;
    std::optional<double> min_contribution;
    bool keep_lengths = false;
    bool force = false;
    bool resolve_coincidences = false;
    bool quiet = false;
    SceneOptions scene_options;
};

/// Where POV-Ray differs from Lancer is not an error, but the user must know it.
void show_reservations(const reference::ExportResult& result, const Scene& scene,
                       const Session& session) {
    std::vector<Diagnostic> found;
    for (const reference::Approximation& a : result.approximations)
        found.push_back({Severity::warning, a.where, a.explanation, "", {}});
    for (const reference::Coincidence& c : result.coincidences) {
        if (c.resolution == reference::Coincidence::Resolution::hidden) continue;
        Diagnostic both{Severity::warning,
                        scene.objects[c.second].place,
                        "a face coincides with a face of another object; which of the two POV-Ray "
                        "shows follows no rule (coincident-surfaces)",
                        fmt::format("use --resolve-coincidences to separate them ({})",
                                    reference::resolution_name(c.resolution)),
                        {}};
        if (c.resolution == reference::Coincidence::Resolution::none)
            both.hint = "move one of the two a little";
        if (c.first == c.second)
            both.message =
                "faces of two parts of this body coincide; which of the two POV-Ray shows follows "
                "no rule (coincident-surfaces)";
        else
            both.notes.push_back(
                {Severity::note, scene.objects[c.first].place, "the other object", "", {}});
        found.push_back(std::move(both));
    }
    for (const reference::KnownDifference& d : result.known_differences) {
        if (d.rule == reference::KnownDifference::Rule::coincident_surfaces) continue;
        const SourceSpan where =
            d.objects.empty() ? SourceSpan{} : scene.objects[d.objects.front()].place;
        found.push_back({Severity::warning,
                         where,
                         fmt::format("{} ({})", d.explanation, reference::rule_name(d.rule)),
                         "",
                         {}});
    }
    session.terminal.show(std::move(found), session.sources);
}

/// A file that somebody else wrote or changed is replaced only with --force.
void check_own(const ExportJob& job, const std::string& path) {
    std::error_code ignored;
    if (job.force || io::is_stream(path) || !fs::exists(path, ignored)) return;
    if (reference::is_signed(io::read_file(path))) return;
    throw UsageError(fmt::format(
        "'{}' exists and is not as lancer export wrote it: use --force to replace it", path));
}

ExitCode export_scene(const ExportJob& job, Session& session) {
    const fs::path output(job.output);
    if (output.extension() != ".pov")
        throw UsageError(
            fmt::format("'{}': the name of a POV-Ray scene must end in .pov", job.output));

    session.will_write(job.output, "-o");
    check_own(job, job.output);
    SceneLoader loader(job.scene, job.scene_options, session);
    Scene scene = loader.load();
    if (job.min_contribution) scene.settings.min_contribution = *job.min_contribution;
    reference::ExportView view;
    view.camera = static_cast<std::uint32_t>(pick_camera(scene, job.camera, session));
    view.width = job.size ? job.size->width : scene.width;
    view.height = job.size ? job.size->height : scene.height;
    const reference::ExportResult result =
        reference::export_pov(scene, view,
                              {.name = output.stem().string(),
                               .exposure = job.exposure.value_or(1),
                               .keep_lengths = job.keep_lengths,
                               .resolve_coincidences = job.resolve_coincidences});
    if (session.terminal.show(result.refusals, session.sources) > 0) return ExitCode::scene;

    std::vector<std::pair<std::string, std::string>> files;  // names and bytes
    for (const reference::Asset& asset : result.assets)
        files.emplace_back((output.parent_path() / asset.name).string(), asset.bytes);
    for (const auto& [path, bytes] : files) {
        session.will_write(path, "an image of " + job.output);
        check_own(job, path);
    }
    files.emplace_back(job.output, result.text);

    if (!job.quiet) show_reservations(result, scene, session);
    for (const auto& [path, bytes] : files) io::write_file(path, reference::with_signature(bytes));
    if (!job.quiet) {
        session.output.say(fmt::format(
            "wrote {}; render it with\n  povray +I{} +W{} +H{} +FN16 File_Gamma=1.0 -D -A\n",
            job.output, job.output, view.width, view.height));
    }
    return ExitCode::done;
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
    CLI::App& command = *app.add_subcommand("export", "Write the equivalent POV-Ray scene");
    const auto job = std::make_shared<ExportJob>();
    command.add_option("SCENE", job->scene, "Scene file; - reads standard input")
        ->required()
        ->type_name("");
    command
        .add_option("-o,--output", job->output,
                    "POV-Ray scene; its images are written to the same folder")
        ->required()
        ->type_name("OUT.pov");
    command.add_option("--camera", job->camera, "Name of the camera; by default the first one")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--size", [job](const std::string& text) { job->size = parse_size(text); },
            "Size of the picture in pixels")
        ->type_name("WxH");
    command.add_flag(
        "--keep-lengths", job->keep_lengths,
        "Keep the scene's lengths; by default they are scaled to where POV-Ray is most exact");
    command.add_flag("--resolve-coincidences", job->resolve_coincidences,
                     "Separate coincident faces by a tiny distance, so that POV-Ray shows what "
                     "Lancer's contact rule shows");
    add_number(command, "--exposure", job->exposure, 1e-300, 1e300,
               "Multiply all light by X, so that no value is above 1 and clipped")
        ->type_name("X");
    add_number(command, "--min-contribution", job->min_contribution, 0, 1,
               "Replaces the scene's min_contribution, as adc_bailout; 0: all rays are followed")
        ->type_name("X");
    command.add_flag("--force", job->force,
                     "Also replace files that export did not write, or that were changed since");
    command.add_flag("-q,--quiet", job->quiet, "Print only mistakes");
    add_scene_options(command, job->scene_options);
    command.footer(
        "Examples:"
        "\n  lancer export scene.lancer -o scene.pov");
    command.callback([&action, job] {
        action = [job](Session& session) { return export_scene(*job, session); };
    });
}

}  // namespace lancer::cli
