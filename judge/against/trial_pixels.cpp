#include "judge/against/trial_pixels.h"

#include <algorithm>

#include "judge/explain/probe_function.h"

namespace lancer::judge {

TrialPixels few_of(const TrialPixels& samples, std::size_t most) {
    TrialPixels few = samples;
    few.points.clear();
    few.ours.clear();
    few.theirs.clear();
    const std::size_t step = samples.different / most + 1;
    for (std::size_t i = 0; i < samples.different; i += step) {
        few.points.push_back(samples.points[i]);
        few.ours.push_back(samples.ours[i]);
        few.theirs.push_back(samples.theirs[i]);
    }
    few.different = few.points.size();
    return few;
}

std::vector<Color> VariantTracer::trace(const Scene& scene) const {
    const auto renderer = compile(scene, scene.settings);
    return trace(*renderer, scene.settings, samples_.points);
}

std::vector<Color> VariantTracer::trace(const Renderer& renderer, const Settings& settings,
                                        const std::vector<PicturePoint>& points) const {
    std::vector<Color> colors(points.size());
    RayCounts counts;
    renderer.trace(view_, points, {settings.max_depth, settings.min_contribution}, colors, {},
                   counts);
    for (Color& color : colors) color = color * samples_.exposure;
    return colors;
}

Color as_held(const Color& color, const TrialPixels& samples) {
    if (!samples.clipped) return color;
    Color held = color;
    for (int c = 0; c < 3; ++c) held[c] = std::clamp(held[c], 0.0, 1.0);
    return held;
}

Effect effect_of(const TrialPixels& samples, const Explanation& explanation) {
    std::size_t repaired = 0;
    std::size_t spoilt = 0;
    std::size_t different = 0;
    std::size_t agreeing = 0;
    const std::vector<std::uint8_t>& left_out = explanation.left_out;
    for (std::size_t i = 0; i < explanation.colors.size(); ++i) {
        if (!left_out.empty() && left_out[i] != 0) continue;
        const Color color = as_held(explanation.colors[i], samples);
        const bool agrees = distance(color, samples.theirs[i]) <= samples.tolerance;
        if (i < samples.different) {
            ++different;
            repaired += agrees ? 1 : 0;
        } else {
            ++agreeing;
            spoilt += agrees ? 0 : 1;
        }
    }
    const auto share = [](std::size_t part, std::size_t of) {
        return of == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(of);
    };
    return {share(repaired, different), share(spoilt, agreeing)};
}

}  // namespace lancer::judge
