#include "model/plain_color.h"

#include <algorithm>

namespace lancer {
namespace {

Color mean(const Checker& checker) {
    return (checker.even + checker.odd) / 2.0;
}

/// The mean of the piecewise linear function over [0, 1]; its end colours extend to both sides.
Color mean(const Gradient& gradient) {
    const auto& stops = gradient.stops;
    const auto inside = [](double at) { return std::clamp(at, 0.0, 1.0); };
    Color sum = stops.front().color * inside(stops.front().at) +
                stops.back().color * (1 - inside(stops.back().at));
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const double from = inside(stops[i].at);
        const double to = inside(stops[i + 1].at);
        if (!(from < to)) continue;
        const double middle = ((from + to) / 2 - stops[i].at) / (stops[i + 1].at - stops[i].at);
        sum += (to - from) * ((1 - middle) * stops[i].color + middle * stops[i + 1].color);
    }
    return sum;
}

Color mean(const Image& image) {
    Color sum(0);
    double weights = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double* p = image.pixel(x, y);
            const double weight = image.channels > 3 ? p[3] : 1.0;
            sum += weight * Color(p[0], p[1], p[2]);
            weights += weight;
        }
    }
    return weights > 0 ? sum / weights : Color(1);
}

}  // namespace

Color plain_color(const Scene& scene, const Material& material) {
    if (material.texture == none) return material.color;
    const auto& pattern = scene.textures[material.texture].pattern;
    if (const auto* image = std::get_if<ImageTexture>(&pattern))
        return mean(*scene.images[image->image].pixels);
    if (const auto* checker = std::get_if<Checker>(&pattern)) return mean(*checker);
    if (const auto* gradient = std::get_if<Gradient>(&pattern)) return mean(*gradient);
    return Color(1);  // vertex colours: many meshes may share the material
}

}  // namespace lancer
