#include "judge/validate/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lancer::judge {

namespace {

/// The power of two that brings the brightest value into 0..1, or 1: POV-Ray's 16-bit picture ends
/// there, and a power of two changes no digit of ours.
double exposure_for(const Image& image) {
    double brightest = 0;
    for (const double value : image.data) {
        if (std::isfinite(value)) brightest = std::max(brightest, value);
    }
    if (brightest <= 1) return 1;
    int exponent = 0;
    std::frexp(brightest, &exponent);  // brightest = m 2^exponent with m in [0.5, 1)
    return std::ldexp(1.0, -exponent);
}

double exposed(double value, double exposure) {
    // NaN passes through, so that the comparison finds it.
    return std::isfinite(value) ? std::clamp(value * exposure, 0.0, 1.0) : value;
}

Image exposed(const Image& image, double exposure) {
    Image result = image;
    for (double& value : result.data) value = exposed(value, exposure);
    return result;
}

ProbeFunction exposed(ProbeFunction probe, double exposure) {
    return [probe = std::move(probe), exposure](double x, double y) {
        Probe sample = probe(x, y);
        for (int c = 0; c < 3; ++c) sample.color[c] = exposed(sample.color[c], exposure);
        return sample;
    };
}

/// The exporter's result taken over; false when the scene goes no further.
bool take_export(Validation& result, const ValidationJob& job, reference::ExportResult& exported) {
    result.factor = exported.factor;
    result.exposure = exported.exposure;
    result.known_differences = exported.known_differences;
    for (const reference::Approximation& a : exported.approximations) {
        result.approximations.push_back(a.explanation);
    }
    result.refusals = exported.refusals;
    if (exported.refusals.empty()) {
        if (!job.expect.refused) return true;
        result.reasons.push_back("the exporter was expected to refuse this scene, and did not");
        return false;
    }
    for (const Diagnostic& refusal : exported.refusals) result.reasons.push_back(refusal.message);
    if (job.expect.refused) {
        result.verdict = Verdict::refused;
        result.reasons.push_back("expected: " + job.expect.refusal_reason);
    }
    return false;
}

void judge_result(Validation& result, const OurPicture& ours, const PovRayRules& rules,
                  const std::function<Image(int, int, double)>& around) {
    reference::CompareOptions options;
    options.fail = result.thresholds.interior;
    options.fail_percent = 100;  // the judgement decides, not this
    result.comparison = reference::compare_images(result.ours, result.theirs, options);
    if (!result.comparison.comparable) {
        result.verdict = Verdict::differs;
        result.reasons.push_back(result.comparison.reason);
        return;
    }
    SecondLook second;
    // Named or not: next to where any two bodies meet, faces are nearer than POV-Ray's constants.
    if (ours.by_rules) {
        PovRayRules none = rules;
        none.followed = false;
        second.by_rules = exposed(ours.by_rules(rules), result.exposure);
        second.without = exposed(ours.by_rules(none), result.exposure);
    }
    second.around = around;
    result.judgement =
        judge_pictures(result.ours, result.theirs, exposed(ours.probe, result.exposure),
                       result.thresholds, second, rays_for_explaining(ours.rays));
    result.verdict = result.judgement.pass ? Verdict::agrees : Verdict::differs;
    result.reasons = result.judgement.failures;
}

void validate(Validation& result, const ValidationJob& job, const OurRenderer& renderer,
              const reference::PovRay& povray, const reference::PovOptions& options) {
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
    reference::PovPicture picture = reference::run_povray(povray, pov_job, options);
    result.pov_seconds = picture.seconds;
    result.from_cache = picture.from_cache;
    result.pov_command = picture.command;
    result.theirs = std::move(picture.image);
    const auto around = [&](int x, int y, double pitch) {
        export_options.close_up = reference::CloseUp{x + 0.5, y + 0.5, pitch};
        reference::ExportResult close = reference::export_pov(*job.scene, job.view, export_options);
        const reference::PovJob close_job{job.name, std::move(close.text), std::move(close.assets),
                                          reference::CloseUp::points, reference::CloseUp::points};
        return reference::run_povray(povray, close_job, options).image;
    };
    judge_result(result, ours, rules, around);
}

}  // namespace

void prepare_for_validation(Scene& scene) {
    scene.settings.samples = 1;
    scene.settings.min_contribution = 0;
}

Validation validate_scene(const ValidationJob& job, const OurRenderer& renderer,
                          const reference::PovRay& povray, const reference::PovOptions& options) {
    Validation result;
    result.name = job.name;
    result.path = job.path;
    result.view = job.view;
    result.thresholds = job.expect.thresholds;
    result.expectations = job.expect.reasons;
    result.pov_version = povray.version;
    try {
        validate(result, job, renderer, povray, options);
    } catch (const FileError& error) {
        result.verdict = Verdict::failed;
        result.reasons.emplace_back(error.what());
    } catch (const SceneError& error) {
        result.verdict = Verdict::failed;
        result.reasons.emplace_back(error.what());
    }
    return result;
}

}  // namespace lancer::judge
