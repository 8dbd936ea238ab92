#include "cli/render_checks.h"

#include <fmt/format.h>

#include "cli/output_names.h"
#include "model/io/file.h"

namespace lancer::cli {
namespace {

void check_error_options(const RenderJob& job) {
    const ErrorOptions& error = job.error;
    if (!error.any()) {
        if (error.no_audit)
            throw UsageError("--no-audit needs --max-error, --max-off, --time or --passes");
        return;
    }
    const std::string option = error.max_error ? "--max-error"
                               : error.max_off ? "--max-off"
                               : error.seconds ? "--time"
                                               : "--passes";
    if (int(error.max_error.has_value()) + int(error.max_off.has_value()) +
            int(error.seconds.has_value()) + int(error.passes.has_value()) >
        1)
        throw UsageError("give only one of --max-error, --max-off, --time and --passes");
    if (job.settings.samples)
        throw UsageError(option + " chooses the samples itself: remove --samples");
    if (job.settings.quality)
        throw UsageError(option + " chooses samples and limits itself: remove --quality");
    if (job.bound_cut)
        throw UsageError("--bound-cut is only for --samples: an audit measures what is cut");
    if (job.settings.sampling == Sampling::grid)
        throw UsageError(option + " uses Sobol points: remove --sampling grid");
}

/// Checks the options about parts and about existing files.
void check_part_options(const RenderJob& job, const std::string& output) {
    if (job.resume) {
        if (job.error.seconds)
            throw UsageError(
                "--resume cannot know what --time would render: use --passes, which can be "
                "repeated");
        const std::string ending = ending_of(output);
        if ((ending != ".png" && ending != ".exr") || io::is_stream(output))
            throw UsageError(
                "--resume needs a .png or .exr file, which records what it was made from");
    }
    if (!job.part) return;
    if (job.error.seconds)
        throw UsageError(
            "--part cannot be used with --time: each part would make its own number of passes");
    if (job.frames) return;
    if (job.bound_cut)
        throw UsageError("--bound-cut is for a whole picture: it cannot be used with --part");
    if (job.error.passes)
        throw UsageError("--part cannot be used with --passes: each pass needs the whole picture");
    if (job.image.bits != 8 || job.image.linear)
        throw UsageError("a part contains exact values: give --bits and --linear to join");
    if (ending_of(output) != ".exr") throw UsageError("--part needs an .exr file: -o part-1.exr");
}

void check_alpha(const RenderJob& job, const std::string& output) {
    if (!job.alpha) return;
    if (job.error.any())
        throw UsageError(
            "--alpha is only for --samples: it cannot be used with --max-error, --max-off, --time "
            "or --passes");
    if (job.part && !job.frames)
        throw UsageError("--alpha cannot be used with --part of a single picture");
    const std::string ending = ending_of(output);
    if (ending != ".png" && ending != ".tif" && ending != ".tiff" && ending != ".exr")
        throw UsageError(fmt::format("--alpha is for .png, .tif and .exr, not for '{}'", output));
}

}  // namespace

void check(const RenderJob& job, const std::string& output) {
    if (job.loop && !job.frames) throw UsageError("--loop needs --frames");
    check_error_options(job);
    check_part_options(job, output);
    check_picture_name(output, job.image, job.aov);
    check_alpha(job, output);
}

}  // namespace lancer::cli
