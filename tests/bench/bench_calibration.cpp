// Are the intervals of --max-error right? The table of docs/cost-of-accuracy.md: runs over pictures
// that are formulas, so that their truths are known without the estimator.
//
//     bench_calibration [SEEDS]      20 by default
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "accuracy/error_target.h"
#include "tests/accuracy/plain_pictures.h"

namespace lancer::accuracy {
namespace {

int all_told = 0;
int all_held = 0;

void row(const PlainPicture& picture, const Image& truth, const View& view, double goal,
         std::uint64_t seeds) {
    const PlainRenderer renderer(picture.formula);
    int told = 0, held = 0, within = 0;
    double worst = 0, rays = 0, deciding = 0, printed = 0;
    const double all_pixels = double(seeds) * view.width * view.height;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        ErrorGoal asked;
        asked.max_error = goal;
        asked.seed = seed;
        const ErrorPicture made =
            render_to_error(renderer, {renderer, limits_of_truth(goal)}, view, asked, {});
        const ErrorEstimate& e = made.report.error;
        const double error = rms_difference(made.image, truth);
        told += made.report.is_told;
        held += made.report.is_told && e.low <= error && error <= e.high;
        within += error <= goal;
        worst = std::max(worst, error / goal);
        rays += static_cast<double>(made.report.picture.primary) / all_pixels;
        deciding += static_cast<double>(made.report.deciding.primary) / all_pixels;
        printed += static_cast<double>(made.report.printed.primary) / all_pixels;
    }
    std::printf("| %s | %g | %d | %d | %d | %.2f | %.2g | %.2g | %.2g |\n", picture.name.c_str(),
                goal, told, held, within, worst, rays, deciding, printed);
    all_told += told;
    all_held += held;
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
        "| picture | asked | told | hold the truth | RMSE within what was asked | worst RMSE / "
        "asked | rays a pixel | to decide | for the print "
        "|\n|---|---|---|---|---|---|---|---|---|");
    for (const PlainPicture& picture : plain_pictures()) {
        const lancer::Image truth =
            truth_of(picture.formula, view, picture.name == "checker" ? 256 : 64);
        for (const double goal : {0.05, 0.02, 0.01, 0.005}) row(picture, truth, view, goal, seeds);
    }
    std::printf("\n%d of %d intervals hold the truth\n", all_held, all_told);
}
