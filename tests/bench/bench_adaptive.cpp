// How many rays the adaptive samples of --max-error take for the error of a full grid of 4 x 4. A
// line for each scene, which tests/bench/study makes a table and a plot of.
//
//     bench_adaptive WIDTH HEIGHT SCENE...
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "accuracy/error_target.h"
#include "tests/bench/judged_pixels.h"

namespace lancer::accuracy {
namespace {

constexpr std::uint32_t most_even = 24;  // Sobol points a pixel
constexpr std::uint32_t grid = 4;

double error_of_grid(const Judge& judge) {
    double error = 0;
    RayCounts uncounted;
    judge.means(
        grid * grid, uncut_limits,
        [](const Judge::Pixel& p, std::uint32_t i) { return Judge::grid_point(p, i, grid); },
        uncounted,
        [&](std::uint32_t n, const std::vector<Color>& values) {
            if (n == grid * grid) error = judge.error(values);
            return true;
        });
    return error;
}

/// Errors of 1, 2 ... Sobol points in every pixel.
std::vector<double> errors_of_even(const Judge& judge) {
    std::vector<double> errors;
    RayCounts uncounted;
    judge.means(
        most_even, uncut_limits,
        [](const Judge::Pixel& p, std::uint32_t i) { return Judge::sobol_point(p, i); }, uncounted,
        [&](std::uint32_t, const std::vector<Color>& values) {
            errors.push_back(judge.error(values));
            return true;
        });
    return errors;
}

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
    const Scene scene = load_scene(path);
    const std::unique_ptr<Renderer> renderer = uncut_renderer(scene);
    const Judge judge(*renderer, view);
    const double wanted = error_of_grid(judge);
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
                wanted, std::max(2.0, rays), deciding, even_rays(wanted, errors_of_even(judge)));
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
