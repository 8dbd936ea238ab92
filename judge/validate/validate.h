// One scene, rendered by us and by POV-Ray, and judged.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "judge/explain/explain.h"
#include "judge/report/report.h"
#include "judge/validate/expect.h"
#include "judge/validate/our_renderer.h"
#include "model/scene.h"
#include "reference/compare/compare.h"
#include "reference/pov/export.h"
#include "reference/povray/runner.h"

namespace lancer::judge {

/// A scene to be validated, without errors and with a camera. Both programs must follow every
/// branch, so `settings` must say samples 1 and min_contribution 0: see prepare_for_validation().
struct ValidationJob {
    std::string name;  ///< for people and for the files' names: `solids`
    std::string path;  ///< as it stood on the command line
    /// The path and the options that choose the scene (--camera, -D), quoted for a shell: for the
    /// commands in the report.
    std::string scene_words;
    /// `file:line:column` of a place in the script, for people; may be empty.
    std::function<std::string(const SourceSpan&)> place_text{};
    std::shared_ptr<const Scene> scene;
    reference::ExportView view;
    Expectations expect;
    /// Told what begins and how much is done, 0..1; from the thread that validates; may be empty.
    std::function<void(double share, const char* what)> progress{};
};

/// The rays that explaining may cost: the picture's own many times over, and some for pictures that
/// cost next to nothing. In rays and not in seconds, so that the verdict depends on no clock.
constexpr std::uint64_t rays_for_explaining(std::uint64_t of_the_picture) {
    return 4 * of_the_picture + 3'000'000;
}

/// What both programs do alike: one ray through each pixel's centre, and no branch left out because
/// it weighs little. The depth of recursion stays the scene's.
void prepare_for_validation(Scene& scene);

struct Validation {
    std::string name;
    std::string path;
    std::string scene_words;
    Verdict verdict = Verdict::failed;
    /// Why it does not agree; for a refusal what the exporter said, as one would read it in a
    /// report.
    std::vector<std::string> reasons;
    /// The exporter's refusals, with their places.
    std::vector<Diagnostic> refusals;

    /// The file that the scene was judged against; empty: POV-Ray was asked.
    std::string picture{};
    /// What makes all of the other picture different, where there is one such thing; asked of files
    /// alone.
    std::optional<std::string> cause{};

    // The rest as far as it came to that.
    reference::ExportView view;
    double factor = 1;    ///< of lengths in the export
    double exposure = 1;  ///< of light, in both pictures
    std::vector<reference::KnownDifference> known_differences;
    std::vector<reference::Coincidence> coincidences;
    std::vector<std::string> coincidence_texts;  ///< one each, with both objects' places
    std::string pov_text;                        ///< the exported scene
    std::vector<reference::Asset> pov_assets;
    std::vector<std::string> approximations;
    std::vector<std::string> expectations;
    Thresholds thresholds;
    Image ours;  ///< times the exposure, clipped to 0..1 as POV-Ray's is
    Image theirs;
    reference::Comparison comparison;
    Judgement judgement;
    double our_seconds = 0;
    double pov_seconds = 0;
    bool from_cache = false;
    std::string pov_command;
    std::string pov_version;
};

/// A validation that `judge` completes: names, view and thresholds are those of the job. Errors of
/// files and scenes are a verdict.
Validation validation_of(const ValidationJob& job, const std::function<void(Validation&)>& judge);

/// Compares the two pictures of `result`; the judgement decides on pixels, not this. False, with
/// the verdict and its reason, when they cannot be compared.
bool compare_pictures(Validation& result);

/// Renders ours, exports, runs POV-Ray, compares and judges. What goes wrong with POV-Ray, the
/// exporter or our renderer is a verdict; throws nothing but what memory throws.
Validation validate_scene(const ValidationJob& job, const OurRenderer& renderer,
                          const reference::PovRay& povray, const reference::PovOptions& options);

}  // namespace lancer::judge
