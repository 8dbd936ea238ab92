// Turned shapes that touch glass, moved so that no coordinate loses a digit: no bit of the picture
// changes. Many more scenes: bench_random moves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/extremes/stage.h"
#include "tests/extremes/turned_scene.h"
#include "tracer/render.h"

namespace lancer::extremes {
namespace {

std::vector<double> pixels_of(const Scene& scene) {
    RayCounts counts;
    const View view{0, scene.width, scene.height, {}, false};
    const Image image = compile(scene, scene.settings)->render(view, {}, counts);
    EXPECT_EQ(counts.media_lost, 0u);
    return image.data;
}

/// The largest difference of a value after a move.
double most_changed(const Scene& scene, double d) {
    const std::vector<double> a = pixels_of(scene);
    const std::vector<double> b = pixels_of(moved(scene, {d, -d, 2 * d}));
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

TEST(Turned, ByQuartersNoBitChanges) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Scene scene = random_turned(seed, Turns::quarters);
        for (const double d : {1e6, 1e11}) EXPECT_EQ(most_changed(scene, d), 0) << seed << " " << d;
    }
}

TEST(Turned, ByAnyAngleNoBitChangesEither) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Scene scene = random_turned(seed, Turns::any);
        for (const double d : {1e6, 1e11}) EXPECT_EQ(most_changed(scene, d), 0) << seed << " " << d;
    }
}

TEST(Turned, CentresAndEndsThatAreRoundedChangeLastDigits) {
    for (unsigned seed = 1; seed <= 6; ++seed)
        EXPECT_LT(most_changed(random_turned(seed, Turns::any_ends), 1e6), 1e-8) << seed;
}

}  // namespace
}  // namespace lancer::extremes
