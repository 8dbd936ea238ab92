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
            throw UsageError("--no-audit goes with --max-error, --max-off, --time or --passes");
        return;
    }
    const std::string option = error.max_error ? "--max-error"
                               : error.max_off ? "--max-off"
                               : error.seconds ? "--time"
                                               : "--passes";
    if (int(error.max_error.has_value()) + int(error.max_off.has_value()) +
            int(error.seconds.has_value()) + int(error.passes.has_value()) >
        1)
        throw UsageError("one of --max-error, --max-off, --time and --passes, not two");
    if (job.settings.samples)
        throw UsageError(option + " chooses the samples: leave --samples out");
    if (job.settings.quality)
        throw UsageError(option + " chooses samples and limits: leave --quality out");
    if (job.bound_cut) throw UsageError("--bound-cut goes with --samples: audits know what is cut");
    if (job.settings.sampling == Sampling::grid)
        throw UsageError(option + " samples at sobol points, not on a grid");
}

/// Parts of a picture, and what is there already.
void check_part_options(const RenderJob& job, const std::string& output) {
    if (job.resume) {
        if (job.error.seconds)
            throw UsageError(
                "--resume cannot know what --time would draw: --passes can be repeated");
        const std::string ending = ending_of(output);
        if ((ending != ".png" && ending != ".exr") || io::is_stream(output))
            throw UsageError(
                "--resume needs a .png or .exr file, which tells what it was made from");
    }
    if (!job.part) return;
    if (job.error.seconds)
        throw UsageError("--part goes with no --time: each part would get passes of its own");
    if (job.frames) return;
    if (job.bound_cut) throw UsageError("--bound-cut goes with a whole picture, not with --part");
    if (job.error.passes)
        throw UsageError("--part goes with no --passes: each looks at the whole picture");
    if (job.image.bits != 8 || job.image.linear)
        throw UsageError("a part holds the exact values: --bits and --linear go with join");
    if (ending_of(output) != ".exr") throw UsageError("--part needs an .exr file: -o part-1.exr");
}

void check_alpha(const RenderJob& job, const std::string& output) {
    if (!job.alpha) return;
    if (job.error.any())
        throw UsageError(
            "--alpha goes with --samples, not with --max-error, --max-off, --time or --passes");
    if (job.part && !job.frames) throw UsageError("a part of one picture has no alpha");
    const std::string ending = ending_of(output);
    if (ending != ".png" && ending != ".tif" && ending != ".tiff" && ending != ".exr")
        throw UsageError(fmt::format("--alpha is for .png, .tif and .exr, not for '{}'", output));
}

}  // namespace

void check(const RenderJob& job, const std::string& output) {
    if (job.loop && !job.frames) throw UsageError("--loop goes with --frames");
    check_error_options(job);
    check_part_options(job, output);
    check_picture_name(output, job.image, job.aov);
    check_alpha(job, output);
}

}  // namespace lancer::cli
