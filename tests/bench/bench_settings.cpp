// Every number of points on a grid or of Sobol points with every depth and every least
// contribution: the cost and the error of each. Costs are rays per pixel; a shadow ray, which needs
// no shading, counts half.
//
//     bench_settings WIDTH HEIGHT all SCENE...         a line for each setting: for presets.py,
//                                                      which has no use for a grid of many
//     bench_settings WIDTH HEIGHT 0.01,0.005 SCENE...  a line for each error: the cheapest setting
//                                                      that holds it, and --max-error's picture
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "accuracy/error_target.h"
#include "model/settings.h"
#include "tests/bench/judged_pixels.h"

namespace lancer::accuracy {
namespace {

constexpr std::uint32_t most_samples = 6;  // n x n
constexpr int depths[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
constexpr double contributions[] = {0.1, 0.03, 0.01, 0.003, 0.001};

double cost_of(const RayCounts& rays) {
    return static_cast<double>(rays.primary + rays.reflected + rays.transmitted) +
           0.5 * static_cast<double>(rays.shadow);
}

struct Setting {
    Sampling sampling = Sampling::grid;
    std::uint32_t samples = 1;  ///< n x n
    TraceLimits limits;
    double error = 0;
    double cost = 0;  ///< rays a pixel
};

/// What samples and limits are tried.
struct Sweep {
    double least_error = 0;   ///< with this error, more samples are not tried
    std::uint32_t grids = 1;  ///< n x n at most
    bool recurses = true;     ///< else limits have no effect
};

/// With these limits.
void sweep_samples(const Judge& judge, const TraceLimits& limits, const Sweep& sweep,
                   std::vector<Setting>& all) {
    const double pixels = static_cast<double>(judge.size());
    double grid_error = 1;
    for (std::uint32_t n = 1; n <= sweep.grids && grid_error > sweep.least_error; ++n) {
        RayCounts rays;
        judge.means(
            n * n, limits,
            [n](const Judge::Pixel& p, std::uint32_t i) { return Judge::grid_point(p, i, n); },
            rays,
            [&](std::uint32_t taken, const std::vector<Color>& values) {
                if (taken < n * n) return true;
                grid_error = judge.error(values);
                all.push_back({Sampling::grid, n, limits, grid_error, cost_of(rays) / pixels});
                return true;
            });
    }
    RayCounts rays;
    std::uint32_t n = 2;
    judge.means(
        most_samples * most_samples, limits,
        [](const Judge::Pixel& p, std::uint32_t i) { return Judge::sobol_point(p, i); }, rays,
        [&](std::uint32_t taken, const std::vector<Color>& values) {
            if (taken < n * n) return true;
            const double error = judge.error(values);
            all.push_back({Sampling::sobol, n++, limits, error, cost_of(rays) / pixels});
            return error > sweep.least_error;
        });
}

std::vector<Setting> swept(const Judge& judge, const Sweep& sweep) {
    std::vector<Setting> all;
    for (const int depth : depths)
        for (const double contribution : contributions) {
            sweep_samples(judge, {depth, contribution}, sweep, all);
            if (!sweep.recurses) return all;
        }
    return all;
}

bool recurses(const Judge& judge) {
    RayCounts one;
    judge.means(
        1, uncut_limits,
        [](const Judge::Pixel& p, std::uint32_t i) { return Judge::sobol_point(p, i); }, one,
        [](std::uint32_t, const std::vector<Color>&) { return true; });
    return one.reflected + one.transmitted > 0;
}

const char* name_of(const Setting& setting) {
    return setting.sampling == Sampling::grid ? "grid" : "sobol";
}

/// Rays of 8 x 8 Sobol points that nothing is cut from.
double cost_of_exact(const Judge& judge) {
    constexpr std::uint32_t points = 64;
    RayCounts rays;
    judge.means(
        points, uncut_limits,
        [](const Judge::Pixel& p, std::uint32_t i) { return Judge::sobol_point(p, i); }, rays,
        [](std::uint32_t, const std::vector<Color>&) { return true; });
    return cost_of(rays) / static_cast<double>(judge.size());
}

void print_all(const std::string& scene, const Judge& judge) {
    const double exact = cost_of_exact(judge);
    for (const Setting& s : swept(judge, {0, 1, recurses(judge)}))
        std::printf("%s,%s,%u,%d,%g,%.6g,%.6g\n", scene.c_str(), name_of(s), s.samples,
                    s.limits.max_depth, s.limits.min_contribution, s.error, s.cost / exact);
    std::fflush(stdout);
}

void print_cheapest(const std::string& scene, const Renderer& renderer, const View& view,
                    const Judge& judge, const std::vector<double>& errors) {
    const double pixels = double(view.width) * view.height;
    const double least_error = *std::min_element(errors.begin(), errors.end());
    const std::vector<Setting> all = swept(judge, {least_error, most_samples, recurses(judge)});
    for (const double asked : errors) {
        const Setting* best = nullptr;
        for (const Setting& s : all)
            if (s.error <= asked && (!best || s.cost < best->cost)) best = &s;
        ErrorGoal goal;
        goal.max_error = asked;
        const ErrorPicture made =
            render_to_error(renderer, {renderer, limits_of_truth(asked)}, view, goal, {});
        const ErrorReport& r = made.report;
        if (!best) continue;
        std::printf("%s,%g,%s,%u,%d,%g,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%d,%g\n",
                    scene.c_str(), asked, name_of(*best), best->samples, best->limits.max_depth,
                    best->limits.min_contribution, best->error, best->cost, judge.error(made.image),
                    r.error.high, r.rays_per_pixel, cost_of(r.picture) / pixels,
                    cost_of(r.deciding) / pixels, cost_of(r.printed) / pixels, r.limits.max_depth,
                    r.limits.min_contribution);
        std::fflush(stdout);
    }
}

void run(const std::string& path, const View& view, const std::vector<double>& errors) {
    const Scene scene = load_scene(path);
    const std::string name = std::filesystem::path(path).stem().string();
    const std::unique_ptr<Renderer> renderer = uncut_renderer(scene);
    const Judge judge(*renderer, view);
    if (errors.empty())
        print_all(name, judge);
    else
        print_cheapest(name, *renderer, view, judge, errors);
}

}  // namespace
}  // namespace lancer::accuracy

int main(int argc, char** argv) {
    if (argc < 5) return 2;
    lancer::View view;
    view.width = std::atoi(argv[1]);
    view.height = std::atoi(argv[2]);
    const bool all = std::string(argv[3]) == "all";
    std::vector<double> errors;
    std::stringstream list(argv[3]);
    for (std::string error; !all && std::getline(list, error, ',');)
        errors.push_back(std::stod(error));
    std::puts(all ? "scene,sampling,samples,depth,contribution,error,cost"
                  : "scene,asked,sampling,samples,depth,contribution,error,cost,made error,"
                    "told high,rays a pixel,picture,deciding,printed,made depth,made contribution");
    for (int i = 4; i < argc; ++i) lancer::accuracy::run(argv[i], view, errors);
}
