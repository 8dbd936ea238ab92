#include "judge/tradeoff/run_setting.h"

#include "accuracy/error_target.h"

namespace lancer::judge {
namespace {

void render_to_error(const Scene& scene, const View& view, const TradeSetting& setting,
                     const Progress& progress, SettingRun& run) {
    const double error = *setting.max_error;
    const TraceLimits limits = accuracy::limits_of_truth(error);
    Settings settings = setting.settings;
    settings.max_depth = limits.max_depth;
    settings.min_contribution = limits.min_contribution;
    settings.samples = 1;
    std::unique_ptr<Renderer> picture;  // needed when the setting changes more than limits
    if (settings.tolerance) picture = compile(scene, settings);
    settings.tolerance = std::nullopt;
    const std::unique_ptr<Renderer> judge = compile(scene, settings);
    accuracy::ErrorGoal goal;
    goal.max_error = error;
    goal.seed = settings.seed;
    goal.audited = setting.audited;
    goal.leaves_out = picture != nullptr;
    accuracy::ErrorPicture made = accuracy::render_to_error(picture ? *picture : *judge,
                                                            {*judge, limits}, view, goal, progress);
    run.image = std::move(made.image);
    run.guessed = std::move(made.errors);
    run.samples = std::move(made.counts);
    for (const RayCounts& rays : {made.report.picture, made.report.deciding, made.report.printed})
        run.rays += rays;
}

}  // namespace

SettingRun run_setting(const Scene& scene, const View& view, const TradeSetting& setting,
                       const Progress& progress) {
    SettingRun run;
    const CostMeter meter;
    if (setting.max_error) {
        render_to_error(scene, view, setting, progress, run);
    } else {
        run.image = compile(scene, setting.settings)->render(view, progress, run.rays);
    }
    run.cost = meter.cost();
    return run;
}

}  // namespace lancer::judge
