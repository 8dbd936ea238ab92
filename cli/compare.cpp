// lancer compare
#include "reference/compare/compare.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <limits>
#include <memory>
#include <string>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/picture_options.h"
#include "judge/report/entry_html.h"
#include "judge/report/folders.h"
#include "judge/validate/exposure.h"
#include "model/io/curve.h"
#include "model/io/image_file.h"
#include "reference/compare/comparison_text.h"
#include "reference/compare/heat_map.h"

namespace lancer::cli {
namespace {

struct CompareJob {
    std::string a;
    std::string b;
    std::string heat_map;
    std::string json;
    std::string junit;
    std::string report;
    std::optional<double> exposure;
    std::optional<double> fail;
    std::optional<double> fail_percent;
    std::string mask;
    std::optional<std::int64_t> window;
    std::optional<double> fail_window;
    bool edges = false;
    bool quiet = false;
};

void write_heat_map(const CompareJob& job, const Image& a, const Image& b,
                    const reference::PixelMask& counted) {
    io::write_image(job.heat_map,
                    reference::heat_map(reference::counted_differences(a, b, counted), a.width),
                    {});
}

reference::CompareOptions options_of(const CompareJob& job) {
    reference::CompareOptions options;
    options.fail = job.fail.value_or(options.fail);
    options.fail_percent = job.fail_percent.value_or(options.fail_percent);
    options.window = static_cast<int>(job.window.value_or(options.window));
    options.fail_window = job.fail_window.value_or(options.fail_window);
    options.edges_may_move = job.edges;
    return options;
}

/// The mask for a pair of pictures, where --mask is a folder: the file there with the same name, or
/// with the ending .png. Empty when there is none.
std::string mask_file(const std::string& folder, const std::string& name) {
    std::error_code ignored;
    const std::filesystem::path own = std::filesystem::path(folder) / name;
    if (std::filesystem::exists(own, ignored)) return own.string();
    const std::filesystem::path png = std::filesystem::path(own).replace_extension(".png");
    return std::filesystem::exists(png, ignored) ? png.string() : std::string();
}

/// The masks that --mask gives to the pairs of two folders.
judge::MaskOf masks_of(const CompareJob& job, Session& session) {
    if (job.mask.empty()) return {};
    std::error_code ignored;
    if (std::filesystem::is_directory(job.mask, ignored)) {
        for (const std::string& name : judge::pictures_in(job.mask))
            session.files.add_input(job.mask + "/" + name);
        return [folder = job.mask](const std::string& name) {
            const std::string file = mask_file(folder, name);
            return file.empty() ? reference::PixelMask{}
                                : reference::mask_from(io::read_image(file));
        };
    }
    session.files.add_input(job.mask);
    return [mask = reference::mask_from(io::read_image(job.mask))](const std::string&) {
        return mask;
    };
}

ExitCode compare_folders(const CompareJob& job, Session& session) {
    if (!job.heat_map.empty() || job.exposure)
        throw UsageError("-o and --exposure are for two pictures; two folders take --report DIR");
    session.will_write(job.json, "--json");
    session.will_write(job.junit, "--junit");
    if (!job.report.empty())
        session.files.add_output_in_new_folder(job.report + "/index.html", "--report");
    for (const std::string& folder : {job.a, job.b})
        for (const std::string& name : judge::pictures_in(folder))
            session.files.add_input(folder + "/" + name);
    const judge::MaskOf masks = masks_of(job, session);
    const auto show = [&](const judge::ReportEntry& entry) {
        if (job.quiet) return;
        session.output.say(fmt::format(
            "{}  {}{}{}\n", entry.name, judge::verdict_name(entry.verdict),
            entry.reasons.empty() ? "" : ": ", entry.reasons.empty() ? "" : entry.reasons.front()));
    };
    const judge::FolderComparison result =
        judge::compare_folders(job.a, job.b, options_of(job), show, masks);
    session.write(job.json, judge::to_json(result, options_of(job)));
    session.write(job.junit, judge::junit_xml("lancer compare", judge::junit_cases(result)));
    if (!job.report.empty()) {
        judge::write_report(result.report, job.report);
        if (!job.quiet) session.output.say(fmt::format("wrote {}/index.html\n", job.report));
    }
    if (result.unreadable > 0) return ExitCode::files;
    return result.pass ? ExitCode::done : ExitCode::differs;
}

ExitCode compare(const CompareJob& job, Session& session) {
    std::error_code ignored;
    const bool is_folder = std::filesystem::is_directory(job.a, ignored);
    if (is_folder && std::filesystem::is_directory(job.b, ignored))
        return compare_folders(job, session);
    if (!job.report.empty()) throw UsageError("--report takes two folders of pictures");
    if (!job.junit.empty()) throw UsageError("--junit takes two folders of pictures");
    if (!job.heat_map.empty() && !io::is_writable_image_name(job.heat_map)) {
        throw UsageError(fmt::format(
            "'{}' does not end in the name of an image format, such as .png", job.heat_map));
    }
    session.will_write(job.heat_map, "-o");
    session.will_write(job.json, "--json");
    session.files.add_input(job.a);
    session.files.add_input(job.b);
    if (!job.mask.empty()) session.files.add_input(job.mask);
    Image a = io::read_image(job.a);
    if (job.exposure)
        for (double& value : a.data) value = judge::exposed(value, *job.exposure);
    const Image b = io::read_image(job.b);
    reference::CompareOptions options = options_of(job);
    if (!job.mask.empty()) options.counted = reference::mask_from(io::read_image(job.mask));
    reference::Comparison comparison = reference::compare_images(a, b, options);
    comparison.curve_a = io::curve_of(job.a);
    comparison.curve_b = io::curve_of(job.b);
    session.write(job.json, reference::to_json(comparison, options));
    if (!job.heat_map.empty() && comparison.comparable) write_heat_map(job, a, b, options.counted);
    if (!job.quiet) session.output.say(reference::to_text(comparison, options));
    return comparison.pass ? ExitCode::done : ExitCode::differs;
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
    CLI::App& command =
        *app.add_subcommand("compare", "Measure how far apart two pictures are, in linear light");
    const auto job = std::make_shared<CompareJob>();
    command.add_option("A", job->a, "The first picture, or folder of pictures")
        ->required()
        ->type_name("");
    command.add_option("B", job->b, "The second picture, or folder of pictures")
        ->required()
        ->type_name("");
    command.add_option("-o,--output", job->heat_map, "Write the differences as a heat map")
        ->type_name("HEAT.png");
    add_number(command, "--fail", job->fail, 0, std::numeric_limits<double>::max(),
               "A pixel that differs by more than X counts as over (default 0)")
        ->type_name("X");
    add_number(command, "--fail-percent", job->fail_percent, 0, 100,
               "The pictures differ when more than P percent of the pixels are over (default 0)")
        ->type_name("P");
    command
        .add_option("--mask", job->mask,
                    "Compare only where this picture is not black; with folders also a folder of "
                    "masks with the same names")
        ->type_name("MASK.png");
    command.add_flag("--edges", job->edges,
                     "Edges may be displaced by up to one pixel: such pixels do not count as over");
    add_whole_number(
        command, "--window", job->window, 1, 65535,
        "Side, in pixels, of the window that is searched for the most differences (default 16)")
        ->type_name("N");
    add_number(command, "--fail-window", job->fail_window, 0, 100,
               "The pictures differ when more than P percent of any window are over (default 100)")
        ->type_name("P");
    command.add_option("--json", job->json, "Write the measures as JSON; - to standard output")
        ->type_name("FILE");
    command
        .add_option("--junit", job->junit,
                    "Two folders: write the results as JUnit XML; - to standard output")
        ->type_name("FILE");
    add_number(command, "--exposure", job->exposure, 0, std::numeric_limits<double>::max(),
               "Multiply A by X and clip it to 0..1 first, as validate does")
        ->type_name("X");
    command.add_option("--report", job->report, "Two folders: write the page DIR/index.html")
        ->type_name("DIR");
    add_picture_options(command);
    command.add_flag("-q,--quiet", job->quiet,
                     "Print nothing: only the exit code tells the result");
    command.footer(
        "Examples:"
        "\n  lancer compare a.png b.png -o differences.png --fail 0.004"
        "\n  lancer compare before after --report differences");
    command.callback(
        [&action, job] { action = [job](Session& session) { return compare(*job, session); }; });
}

}  // namespace lancer::cli
