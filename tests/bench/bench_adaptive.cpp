// How many rays the adaptive samples of --max-error take for the error of a full grid of 4 x 4. A
// line for each scene, which tests/bench/study makes a table and a plot of.
//
//     bench_adaptive WIDTH HEIGHT SCENE...
//
// Errors are judged in some thousand pixels, one drawn in each of as many squares: so the truth
// takes as long for a large picture as for a small one.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "accuracy/error_target.h"
#include "model/io/file.h"
#include "model/sobol.h"
#include "parser/parse.h"

namespace lancer::accuracy {
namespace {

constexpr std::int64_t most_pixels = 12288;
constexpr std::uint32_t truth_points = 128;  // of each of two halves
constexpr std::uint32_t most_even = 24;      // Sobol points a pixel
constexpr int grid = 4;
constexpr std::uint64_t truth_stream = 77;

Scene load(const std::string& path) {
    SourceMap sources;
    std::vector<Diagnostic> found;
    const Script script = parse_script(path, io::read_file(path, 1 << 24), {}, sources, found);
    Evaluation evaluation = evaluate(script, {}, {}, sources, found);
    for (const Diagnostic& d : found)
        if (d.severity == Severity::error) throw std::runtime_error(path + ": " + d.message);
    return std::move(evaluation.scene);
}

/// The pixels in which errors are judged, and what they should be.
class Judge {
  public:
    Judge(const Renderer& renderer, const View& view, const TraceLimits& limits)
        : renderer_(renderer), view_(view), limits_(limits) {
        int edge = 1;
        while (std::int64_t(view.width / edge) * (view.height / edge) > most_pixels) ++edge;
        for (int y = 0; y + edge <= view.height; y += edge)
            for (int x = 0; x + edge <= view.width; x += edge) {
                const SquarePoint at = SobolPoints(pixel_key(3, x, y, truth_stream))[0];
                places_.push_back(
                    {x + static_cast<int>(at.x * edge), y + static_cast<int>(at.y * edge)});
            }
        for (unsigned half : {0U, 1U})
            truth_[half] = means(truth_points, [&](const Place& p, std::uint32_t i) {
                               return at(p, pixel_key(3, p.x, p.y, truth_stream + 1 + half), i);
                           }).back();
    }

    /// RMSE of values in the pixels.
    double error(const std::vector<Color>& values) const {
        double sum = 0;
        for (std::size_t k = 0; k < places_.size(); ++k)
            sum += dot(values[k] - truth_[0][k], values[k] - truth_[1][k]) / 3;
        return std::sqrt(std::max(1e-20, sum / static_cast<double>(places_.size())));
    }

    double error(const Image& picture) const {
        std::vector<Color> values;
        for (const Place& p : places_) {
            const double* pixel = picture.pixel(p.x, p.y);
            values.emplace_back(pixel[0], pixel[1], pixel[2]);
        }
        return error(values);
    }

    double error_of_grid() const {
        return error(means(grid * grid, [](const Place& p, std::uint32_t i) {
                         return PicturePoint{p.x + (i % grid + 0.5) / grid,
                                             p.y + (double(i / grid) + 0.5) / grid};
                     }).back());
    }

    /// Errors of 1, 2 ... Sobol points in every pixel.
    std::vector<double> errors_of_even() const {
        std::vector<double> errors;
        for (const std::vector<Color>&values : means(most_even, [](const Place&p, std::uint32_t i) {
                 return at(p, pixel_key(0, p.x, p.y), i);
             }))
            errors.push_back(error(values));
        return errors;
    }

  private:
    struct Place {
        int x = 0;
        int y = 0;
    };

    static PicturePoint at(const Place& p, std::uint64_t key, std::uint32_t index) {
        const SquarePoint point = SobolPoints(key)[index];
        return {p.x + point.x, p.y + point.y};
    }

    /// The means over the first, the first two ... points of each pixel.
    template <class PointOf>
    std::vector<std::vector<Color>> means(std::uint32_t count, const PointOf& point_of) const {
        std::vector<Color> sums(places_.size(), Color{0, 0, 0});
        std::vector<std::vector<Color>> all;
        std::vector<PicturePoint> points;
        std::vector<Color> colors(places_.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            points.clear();
            for (const Place& p : places_) points.push_back(point_of(p, i));
            RayCounts rays;
            renderer_.trace(view_, points, limits_, colors, {}, rays);
            std::vector<Color> now;
            for (std::size_t k = 0; k < sums.size(); ++k) {
                sums[k] += colors[k];
                now.push_back(sums[k] / static_cast<double>(i + 1));
            }
            if (count <= most_even || i + 1 == count) all.push_back(std::move(now));
        }
        return all;
    }

    const Renderer& renderer_;
    const View& view_;
    TraceLimits limits_;
    std::vector<Place> places_;
    std::array<std::vector<Color>, 2> truth_;
};

struct Point {
    double error = 0;
    double rays = 0;
};

/// Rays for an error, on the line through two points, both logarithmic.
double rays_at(double error, const Point& a, const Point& b) {
    if (a.error == b.error || a.rays == b.rays) return b.rays;
    const double slope = std::log(b.rays / a.rays) / std::log(b.error / a.error);
    return b.rays * std::pow(error / b.error, slope);
}

double even_rays(double error, const std::vector<double>& errors) {
    for (std::size_t n = 1; n < errors.size(); ++n)
        if (errors[n] <= error)
            return rays_at(error, {errors[n - 1], double(n)}, {errors[n], double(n + 1)});
    return static_cast<double>(errors.size());
}

void run(const std::string& path, const View& view) {
    const Scene scene = load(path);
    Settings settings = scene.settings;
    settings.max_depth = 1000;
    settings.min_contribution = 1e-6;
    settings.tolerance = std::nullopt;
    settings.precision = Precision::double_;
    settings.threads = 0;
    const std::unique_ptr<Renderer> renderer = compile(scene, settings);
    const Judge judge(*renderer, view, {settings.max_depth, settings.min_contribution});
    const double wanted = judge.error_of_grid();
    const double pixels = double(view.width) * view.height;
    ErrorGoal goal;
    goal.max_error = 1.4 * wanted;
    goal.audited = false;
    std::vector<Point> made;
    double deciding = 0;
    for (int look = 0; look < 3; ++look) {
        const ErrorPicture picture = render_to_error(
            *renderer, {*renderer, limits_of_truth(goal.max_error)}, view, goal, {});
        made.push_back({judge.error(picture.image), picture.report.rays_per_pixel});
        deciding = static_cast<double>(picture.report.deciding.primary) / pixels;
        if (std::abs(std::log(made.back().error / wanted)) < 0.03) break;
        goal.max_error *= wanted / made.back().error;
    }
    double rays = made.back().rays;
    if (made.size() > 1) rays = rays_at(wanted, made[made.size() - 2], made.back());
    std::printf("%s,%d,%d,%.6g,%.6g,%.6g,%.6g\n",
                std::filesystem::path(path).stem().string().c_str(), view.width, view.height,
                wanted, std::max(2.0, rays), deciding, even_rays(wanted, judge.errors_of_even()));
    std::fflush(stdout);
}

}  // namespace
}  // namespace lancer::accuracy

int main(int argc, char** argv) {
    if (argc < 4) return 2;
    lancer::View view;
    view.width = std::atoi(argv[1]);
    view.height = std::atoi(argv[2]);
    std::puts("scene,width,height,error,adaptive,deciding,sobol");
    for (int i = 3; i < argc; ++i) lancer::accuracy::run(argv[i], view);
}
