#include "judge/pack/exact_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "judge/explain/probe_function.h"

namespace lancer::judge {

namespace {

// The channels of Renderer::render().
constexpr int object_channel = 3;
constexpr int depth_channel = 4;
constexpr int normal_channel = 5;
constexpr int shadow_channel = 8;

/// Two roundings of one value do not differ by more. A larger difference means an edge, or a slope
/// as steep as one.
constexpr double most_rounding = 1e-7;

std::unique_ptr<Renderer> compiled(const Scene& scene, Precision precision) {
    Settings settings = scene.settings;
    settings.precision = precision;
    return compile(scene, settings);
}

double relative(double a, double b) {
    return std::abs(a - b) / std::max({std::abs(a), std::abs(b), 1e-300});
}

/// Adds the error of rounding to the nearest double.
double with_rounding(double error, double value) {
    return error + std::abs(value) * std::numeric_limits<double>::epsilon();
}

Json vector_error(const Vec3d& a, const Vec3d& b) {
    Json errors = Json::array();
    for (int c = 0; c < 3; ++c) errors.push_back(with_rounding(std::abs(a[c] - b[c]), a[c]));
    return errors;
}

/// The pixels to probe: the first of each object, then others evenly over the picture.
std::vector<std::size_t> chosen_pixels(const ExactPicture& picture, std::size_t count) {
    std::map<double, std::vector<std::size_t>> by_object;
    std::vector<std::size_t> all;
    const auto channels = static_cast<std::size_t>(picture.image.channels);
    for (std::size_t i = 0; i < picture.is_undecided.size(); ++i) {
        if (picture.is_undecided[i] != 0) continue;
        by_object[picture.image.data[i * channels + object_channel]].push_back(i);
        all.push_back(i);
    }
    std::vector<std::size_t> chosen;
    for (const auto& [object, pixels] : by_object)
        if (chosen.size() < count) chosen.push_back(pixels[pixels.size() / 2]);
    const std::size_t more = count - chosen.size();
    for (std::size_t k = 0; k < more && !all.empty(); ++k)
        chosen.push_back(all[(2 * k + 1) * all.size() / (2 * more)]);
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

}  // namespace

ExactPicture exact_picture(const Scene& scene, const View& view) {
    View all = view;
    all.aov = true;
    RayCounts ignored;
    ExactPicture exact;
    exact.image = compiled(scene, Precision::extended)->render(all, {}, ignored);
    const Image plain = compiled(scene, Precision::double_)->render(all, {}, ignored);
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const double* a = exact.image.pixel(x, y);
            const double* b = plain.pixel(x, y);
            double color = 0;
            double normal = 0;
            for (int c = 0; c < 3; ++c) {
                color = std::max(color, std::abs(a[c] - b[c]));
                normal = std::max(normal, std::abs(a[normal_channel + c] - b[normal_channel + c]));
            }
            const double depth = relative(a[depth_channel], b[depth_channel]);
            const bool undecided =
                a[object_channel] != b[object_channel] || a[shadow_channel] != b[shadow_channel] ||
                color > most_rounding || normal > most_rounding || depth > most_rounding;
            exact.is_undecided.push_back(undecided ? 1 : 0);
            if (undecided) continue;
            exact.color_error = std::max(exact.color_error, color);
            exact.depth_error = std::max(exact.depth_error, depth);
            exact.normal_error = std::max(exact.normal_error, normal);
        }
    }
    return exact;
}

Json exact_probes(const Scene& scene, const View& view, const ExactPicture& picture,
                  std::size_t count) {
    const auto fine = compiled(scene, Precision::extended);
    const auto plain = compiled(scene, Precision::double_);
    Json probes = Json::array();
    const auto width = static_cast<std::size_t>(view.width);
    for (const std::size_t i : chosen_pixels(picture, count)) {
        const double x = static_cast<double>(i % width) + 0.5;
        const double y = static_cast<double>(i / width) + 0.5;
        const Probe a = fine->probe(view, x, y);
        const Probe b = plain->probe(view, x, y);
        if (a.path != b.path || distance(a.color, b.color) > most_rounding) continue;
        Json probe{{"x", i % width},
                   {"y", i / width},
                   {"color", to_json(a.color)},
                   {"color_error", vector_error(a.color, b.color)},
                   {"object", a.object == none ? Json(nullptr) : Json(a.object)}};
        if (a.object != none) {
            probe["depth"] = a.depth;
            probe["depth_error"] = with_rounding(std::abs(a.depth - b.depth), a.depth);
            probe["normal"] = to_json(a.normal);
            probe["normal_error"] = vector_error(a.normal, b.normal);
            Json lit = Json::array();
            for (std::size_t k = 0; k < std::min<std::size_t>(64, scene.lights.size()); ++k)
                lit.push_back((a.lit >> k & 1) != 0);
            probe["lit"] = std::move(lit);
        }
        probes.push_back(std::move(probe));
    }
    return probes;
}

}  // namespace lancer::judge
