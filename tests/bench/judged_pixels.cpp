#include "tests/bench/judged_pixels.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/io/file.h"
#include "model/sobol.h"
#include "parser/parse.h"

namespace lancer::accuracy {
namespace {

constexpr std::int64_t most_pixels = 12288;
constexpr std::uint32_t truth_points = 128;  // of each of two halves
constexpr std::uint64_t truth_seed = 3;
constexpr std::uint64_t truth_stream = 77;

}  // namespace

Scene load_scene(const std::string& path) {
    SourceMap sources;
    std::vector<Diagnostic> found;
    const Script script = parse_script(path, io::read_file(path, 1 << 24), {}, sources, found);
    Evaluation evaluation = evaluate(script, {}, {}, sources, found);
    for (const Diagnostic& d : found)
        if (d.severity == Severity::error) throw std::runtime_error(path + ": " + d.message);
    return std::move(evaluation.scene);
}

std::unique_ptr<Renderer> uncut_renderer(const Scene& scene) {
    Settings settings = scene.settings;
    settings.max_depth = uncut_limits.max_depth;
    settings.min_contribution = uncut_limits.min_contribution;
    settings.tolerance = std::nullopt;
    settings.precision = Precision::double_;
    settings.threads = 0;
    return compile(scene, settings);
}

Judge::Judge(const Renderer& renderer, const View& view) : renderer_(renderer), view_(view) {
    int edge = 1;
    while (std::int64_t(view.width / edge) * (view.height / edge) > most_pixels) ++edge;
    for (int y = 0; y + edge <= view.height; y += edge)
        for (int x = 0; x + edge <= view.width; x += edge) {
            const SquarePoint at = SobolPoints(pixel_key(truth_seed, x, y, truth_stream))[0];
            pixels_.push_back(
                {x + static_cast<int>(at.x * edge), y + static_cast<int>(at.y * edge)});
        }
    for (unsigned half : {0U, 1U}) {
        const auto point = [half](const Pixel& p, std::uint32_t i) {
            return sobol_point(p, i, truth_seed, truth_stream + 1 + half);
        };
        RayCounts uncounted;
        means(truth_points, uncut_limits, point, uncounted,
              [&](std::uint32_t n, const std::vector<Color>& values) {
                  if (n == truth_points) truth_[half] = values;
                  return true;
              });
    }
}

double Judge::error(const std::vector<Color>& values) const {
    double sum = 0;
    for (std::size_t k = 0; k < pixels_.size(); ++k)
        sum += dot(values[k] - truth_[0][k], values[k] - truth_[1][k]) / 3;
    return std::sqrt(std::max(1e-20, sum / static_cast<double>(pixels_.size())));
}

double Judge::error(const Image& picture) const {
    std::vector<Color> values;
    for (const Pixel& p : pixels_) {
        const double* pixel = picture.pixel(p.x, p.y);
        values.emplace_back(pixel[0], pixel[1], pixel[2]);
    }
    return error(values);
}

void Judge::means(std::uint32_t most, const TraceLimits& limits, const PointOf& point_of,
                  RayCounts& rays, const Take& take) const {
    std::vector<Color> sums(pixels_.size(), Color{0, 0, 0});
    std::vector<Color> now(pixels_.size());
    std::vector<Color> colors(pixels_.size());
    std::vector<PicturePoint> points(pixels_.size());
    for (std::uint32_t i = 0; i < most; ++i) {
        for (std::size_t k = 0; k < points.size(); ++k) points[k] = point_of(pixels_[k], i);
        renderer_.trace(view_, points, limits, colors, {}, rays);
        for (std::size_t k = 0; k < sums.size(); ++k) {
            sums[k] += colors[k];
            now[k] = sums[k] / static_cast<double>(i + 1);
        }
        if (!take(i + 1, now)) return;
    }
}

PicturePoint Judge::grid_point(const Pixel& pixel, std::uint32_t index, std::uint32_t n) {
    return {pixel.x + (index % n + 0.5) / n, pixel.y + (double(index / n) + 0.5) / n};
}

PicturePoint Judge::sobol_point(const Pixel& pixel, std::uint32_t index, std::uint64_t seed,
                                std::uint64_t stream) {
    const SquarePoint point = SobolPoints(pixel_key(seed, pixel.x, pixel.y, stream))[index];
    return {pixel.x + point.x, pixel.y + point.y};
}

}  // namespace lancer::accuracy
