#include "judge/validate/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "judge/report/shell_text.h"
#include "judge/validate/exposure.h"
#include "judge/validate/place_words.h"

namespace lancer::judge {

namespace {

Image exposed(const Image& image, double exposure) {
    Image result = image;
    for (double& value : result.data) value = judge::exposed(value, exposure);
    return result;
}

ProbeFunction exposed(ProbeFunction probe, double exposure) {
    return [probe = std::move(probe), exposure](double x, double y) {
        Probe sample = probe(x, y);
        for (int c = 0; c < 3; ++c) sample.color[c] = judge::exposed(sample.color[c], exposure);
        return sample;
    };
}

std::string text_of(const reference::Coincidence& coincidence, const ValidationJob& job) {
    const auto object = [&](std::uint32_t index) { return object_words(job, index); };
    if (coincidence.first == coincidence.second)
        return fmt::format("two parts of {}: {}", object(coincidence.first),
                           reference::resolution_name(coincidence.resolution));
    return fmt::format("{} and {}: {}", object(coincidence.first), object(coincidence.second),
                       reference::resolution_name(coincidence.resolution));
}

/// Takes over the exporter's result; false when the validation must stop.
bool take_export(Validation& result, const ValidationJob& job, reference::ExportResult& exported) {
    result.factor = exported.factor;
    result.exposure = exported.exposure;
    result.known_differences = exported.known_differences;
    for (const reference::Approximation& a : exported.approximations) {
        result.approximations.push_back(a.explanation);
    }
    result.coincidences = exported.coincidences;
    for (const reference::Coincidence& c : exported.coincidences)
        result.coincidence_texts.push_back(text_of(c, job));
    result.refusals = exported.refusals;
    if (exported.refusals.empty()) {
        if (!job.expect.refused) return true;
        result.reasons.push_back("the exporter was expected to refuse this scene, but did not");
        return false;
    }
    for (const Diagnostic& refusal : exported.refusals) result.reasons.push_back(refusal.message);
    if (job.expect.refused) {
        result.verdict = Verdict::refused;
        result.reasons.push_back("expected: " + job.expect.refusal_reason);
    }
    return false;
}

/// Runs POV-Ray on parts and variants of the scene.
class PovRayAgain {
  public:
    PovRayAgain(const ValidationJob& job, const reference::ExportOptions& options,
                const reference::PovRay& povray, const reference::PovOptions& pov_options)
        : job_(job), options_(options), povray_(povray), pov_options_(pov_options) {}

    Image around(int x, int y, double pitch) const {
        reference::ExportOptions close = options_;
        close.close_up = reference::CloseUp{x + 0.5, y + 0.5, pitch};
        return picture(reference::export_pov(*job_.scene, job_.view, close),
                       reference::CloseUp::points, reference::CloseUp::points);
    }

    const ResolvedPicture& resolved() {
        if (resolved_) return *resolved_;
        reference::ExportOptions apart = options_;
        apart.resolve_coincidences = true;
        reference::ExportResult exported = reference::export_pov(*job_.scene, job_.view, apart);
        const PovRayRules rules = rules_of(exported);
        PovRayRules none = rules;
        none.followed = false;
        const std::shared_ptr<const Scene> scene = exported.resolved;
        const View view = tracer_view(job_.view);
        resolved_.emplace();
        resolved_->theirs = picture(std::move(exported), job_.view.width, job_.view.height);
        resolved_->by_rules = exposed(probe_by_rules(scene, view, rules), options_.exposure);
        resolved_->without = exposed(probe_by_rules(scene, view, none), options_.exposure);
        return *resolved_;
    }

  private:
    Image picture(reference::ExportResult exported, int width, int height) const {
        const reference::PovJob job{job_.name, std::move(exported.text), std::move(exported.assets),
                                    width, height};
        return reference::run_povray(povray_, job, pov_options_).image;
    }

    const ValidationJob& job_;
    reference::ExportOptions options_;
    const reference::PovRay& povray_;
    const reference::PovOptions& pov_options_;
    std::optional<ResolvedPicture> resolved_;
};

/// Whether faces coincide and all of them can be told apart. If some remained, POV-Ray could have
/// our value there by chance in one of two pictures.
bool can_be_resolved(const std::vector<reference::Coincidence>& coincidences) {
    using Resolution = reference::Coincidence::Resolution;
    const auto are = [&](Resolution resolution) {
        return static_cast<std::size_t>(
            std::count_if(coincidences.begin(), coincidences.end(),
                          [&](const auto& c) { return c.resolution == resolution; }));
    };
    return are(Resolution::none) == 0 && are(Resolution::hidden) < coincidences.size();
}

void judge_result(Validation& result, const OurPicture& ours, const PovRayRules& rules,
                  PovRayAgain& again) {
    if (!compare_pictures(result)) return;
    SecondLook second;
    // Needed even without named rules: where two bodies meet, faces are nearer than POV-Ray's
    // constants.
    if (ours.by_rules) {
        PovRayRules none = rules;
        none.followed = false;
        second.by_rules = exposed(ours.by_rules(rules), result.exposure);
        second.without = exposed(ours.by_rules(none), result.exposure);
    }
    second.around = [&](int x, int y, double pitch) { return again.around(x, y, pitch); };
    if (can_be_resolved(result.coincidences))
        second.resolved = [&]() -> const ResolvedPicture& { return again.resolved(); };
    result.judgement =
        judge_pictures(result.ours, result.theirs, exposed(ours.probe, result.exposure),
                       result.thresholds, second, rays_for_explaining(ours.rays));
    result.verdict = result.judgement.pass ? Verdict::agrees : Verdict::differs;
    result.reasons = result.judgement.failures;
}

void validate(Validation& result, const ValidationJob& job, const OurRenderer& renderer,
              const reference::PovRay& povray, const reference::PovOptions& options) {
    const auto tell = [&](double share, const char* what) {
        if (job.progress) job.progress(share, what);
    };
    tell(0, "Lancer renders");
    const OurPicture ours = renderer(job.scene, job.view);
    result.our_seconds = ours.seconds;

    reference::ExportOptions export_options;
    export_options.name = job.name;
    export_options.exposure = exposure_for(ours.image);
    reference::ExportResult exported = reference::export_pov(*job.scene, job.view, export_options);
    result.ours = exposed(ours.image, export_options.exposure);
    const PovRayRules rules = rules_of(exported);
    if (!take_export(result, job, exported)) return;

    const reference::PovJob pov_job{job.name, std::move(exported.text), std::move(exported.assets),
                                    job.view.width, job.view.height};
    result.pov_text = pov_job.text;
    result.pov_assets = pov_job.assets;
    tell(0.3, "POV-Ray renders");
    reference::PovPicture picture = reference::run_povray(povray, pov_job, options);
    result.pov_seconds = picture.seconds;
    result.from_cache = picture.from_cache;
    result.pov_command = picture.command;
    result.theirs = std::move(picture.image);
    tell(0.8, "differences are explained");
    PovRayAgain again(job, export_options, povray, options);
    judge_result(result, ours, rules, again);
}

}  // namespace

void prepare_for_validation(Scene& scene) {
    scene.settings.samples = 1;
    scene.settings.min_contribution = 0;
}

bool compare_pictures(Validation& result) {
    reference::CompareOptions options;
    options.fail = result.thresholds.interior;
    options.fail_percent = 100;
    result.comparison = reference::compare_images(result.ours, result.theirs, options);
    if (result.comparison.comparable) return true;
    result.verdict = Verdict::differs;
    result.reasons.push_back(result.comparison.reason);
    return false;
}

Validation validation_of(const ValidationJob& job, const std::function<void(Validation&)>& judge) {
    Validation result;
    result.name = job.name;
    result.path = job.path;
    result.scene_words = job.scene_words.empty() ? shell_quoted(job.path) : job.scene_words;
    result.view = job.view;
    result.thresholds = job.expect.thresholds;
    result.expectations = job.expect.reasons;
    try {
        judge(result);
    } catch (const FileError& error) {
        result.verdict = Verdict::failed;
        result.reasons.emplace_back(error.what());
    } catch (const SceneError& error) {
        result.verdict = Verdict::failed;
        result.reasons.emplace_back(error.what());
    }
    return result;
}

Validation validate_scene(const ValidationJob& job, const OurRenderer& renderer,
                          const reference::PovRay& povray, const reference::PovOptions& options) {
    return validation_of(job, [&](Validation& result) {
        result.pov_version = povray.version;
        validate(result, job, renderer, povray, options);
    });
}

}  // namespace lancer::judge
