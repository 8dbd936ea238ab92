#include "judge/against/samples.h"

#include <algorithm>

#include "judge/explain/probe_function.h"

namespace lancer::judge {

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

Color as_held(const Color& color, const Samples& samples) {
    if (!samples.clipped) return color;
    Color held = color;
    for (int c = 0; c < 3; ++c) held[c] = std::clamp(held[c], 0.0, 1.0);
    return held;
}

Effect effect_of(const Samples& samples, const std::vector<Color>& colors) {
    std::size_t repaired = 0;
    std::size_t spoilt = 0;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const bool agrees =
            distance(as_held(colors[i], samples), samples.theirs[i]) <= samples.tolerance;
        if (i < samples.different) {
            repaired += agrees ? 1 : 0;
        } else {
            spoilt += agrees ? 0 : 1;
        }
    }
    const auto share = [](std::size_t part, std::size_t of) {
        return of == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(of);
    };
    return {share(repaired, samples.different), share(spoilt, colors.size() - samples.different)};
}

}  // namespace lancer::judge
