// Checks the intervals of --max-error on pictures that are formulas, whose truths are known without
// the estimator. Writes a line for each run; tests/bench/study makes a table and a plot of them.
//
//     bench_calibration [SEEDS [PICTURE...]]      20 by default, of all
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "accuracy/error_target.h"
#include "tests/accuracy/plain_pictures.h"

namespace lancer::accuracy {
namespace {

void runs(const PlainPicture& picture, const Image& truth, const View& view, double goal,
          std::uint64_t seeds) {
    const PlainRenderer renderer(picture.formula);
    const double pixels = double(view.width) * view.height;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        ErrorGoal asked;
        asked.max_error = goal;
        asked.seed = seed;
        const ErrorPicture made =
            render_to_error(renderer, {renderer, limits_of_truth(goal)}, view, asked, {});
        const auto rays = [&](const RayCounts& counts) {
            return static_cast<double>(counts.primary) / pixels;
        };
        const ErrorReport& report = made.report;
        std::printf("%s,%g,%d,%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", picture.name.c_str(), goal,
                    static_cast<int>(seed), report.is_told, report.error.low, report.error.high,
                    rms_difference(made.image, truth), rays(report.picture), rays(report.deciding),
                    rays(report.printed));
    }
    std::fflush(stdout);
}

}  // namespace
}  // namespace lancer::accuracy

int main(int argc, char** argv) {
    using namespace lancer::accuracy;
    const std::uint64_t seeds = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20;
    lancer::View view;
    view.width = 128;
    view.height = 96;
    std::puts(
        "picture,asked,seed,told,low,high,error,picture rays,deciding rays,printed audit's rays");
    const std::vector<std::string> wanted(argv + std::min(argc, 2), argv + argc);
    for (const PlainPicture& picture : plain_pictures()) {
        if (!wanted.empty() &&
            std::find(wanted.begin(), wanted.end(), picture.name) == wanted.end())
            continue;
        const lancer::Image truth =
            truth_of(picture.formula, view, picture.name == "checker" ? 256 : 64);
        for (const double goal : {0.05, 0.02, 0.01, 0.005}) runs(picture, truth, view, goal, seeds);
    }
}
