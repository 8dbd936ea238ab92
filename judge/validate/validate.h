// Renders one scene with Lancer and with POV-Ray, and judges the pictures.
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
/// branch, so `settings` must have samples 1 and min_contribution 0: see prepare_for_validation().
struct ValidationJob {
    std::string name;  ///< for people and file names: `solids`
    std::string path;  ///< as given on the command line
    /// The path and the options that select the scene (--camera, -D), quoted for a shell: for the
    /// commands in the report.
    std::string scene_words;
    /// `file:line:column` of a place in the script, for people; may be empty.
    std::function<std::string(const SourceSpan&)> place_text{};
    std::shared_ptr<const Scene> scene;
    reference::ExportView view;
    Expectations expect;
    /// Called with the share done, 0..1, and the current step, from the validating thread; may be
    /// empty.
    std::function<void(double share, const char* what)> progress{};
};

/// The number of rays that explanations may cost: a multiple of the picture's own, and some for
/// very cheap pictures. A limit in seconds would make the verdict depend on the clock.
constexpr std::uint64_t rays_for_explaining(std::uint64_t of_the_picture) {
    return 4 * of_the_picture + 3'000'000;
}

/// Makes both programs do the same: one ray through each pixel's centre, and no branch left out for
/// its small weight. The depth of recursion remains the scene's.
void prepare_for_validation(Scene& scene);

struct Validation {
    std::string name;
    std::string path;
    std::string scene_words;
    Verdict verdict = Verdict::failed;
    /// Why the pictures do not agree; for a refusal, the exporter's message in a form for the
    /// report.
    std::vector<std::string> reasons;
    /// The exporter's refusals, with their places.
    std::vector<Diagnostic> refusals;

    /// The file against which the scene was judged; empty for POV-Ray.
    std::string picture{};
    /// A single cause of all differences, if there is one; only for pictures from files.
    std::optional<std::string> cause{};

    // The other members are set as far as the validation came.
    reference::ExportView view;
    double factor = 1;    ///< of lengths in the export
    double exposure = 1;  ///< of light, in both pictures
    std::vector<reference::KnownDifference> known_differences;
    std::vector<reference::Coincidence> coincidences;
    std::vector<std::string> coincidence_texts;  ///< one per pair, with both objects' places
    std::string pov_text;                        ///< the exported scene
    std::vector<reference::Asset> pov_assets;
    std::vector<std::string> approximations;
    std::vector<std::string> expectations;
    Thresholds thresholds;
    Image ours;  ///< multiplied by the exposure, clipped to 0..1 like POV-Ray's
    Image theirs;
    reference::Comparison comparison;
    Judgement judgement;
    double our_seconds = 0;
    double pov_seconds = 0;
    bool from_cache = false;
    std::string pov_command;
    std::string pov_version;
};

/// Makes a validation with names, view and thresholds of the job, which `judge` completes. Errors
/// of files and scenes become a verdict.
Validation validation_of(const ValidationJob& job, const std::function<void(Validation&)>& judge);

/// Measures the differences of the two pictures of `result`; the judgement does not depend on this.
/// Returns false, with a verdict and a reason, when they cannot be compared.
bool compare_pictures(Validation& result);

/// Renders our picture, exports, runs POV-Ray, compares and judges. A failure of POV-Ray, the
/// exporter or our renderer is a verdict; throws only std::bad_alloc.
Validation validate_scene(const ValidationJob& job, const OurRenderer& renderer,
                          const reference::PovRay& povray, const reference::PovOptions& options);

}  // namespace lancer::judge
