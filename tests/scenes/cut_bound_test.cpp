// The light that limits cut in every scene of scenes/ never exceeds its bound.
#include "accuracy/cut_bound.h"

#include <gtest/gtest.h>

#include "tests/scenes/every_scene.h"

namespace lancer {
namespace {

/// One ray per pixel centre; `deep` follows at least as far as all tested limits.
void expect_within_bound(Scene scene, const std::string& path) {
    // With less than 1e-4, two branches at every surface of glass would never end.
    const TraceLimits deep{24, 1e-4};
    scene.settings.max_depth = deep.max_depth;
    scene.settings.min_contribution = deep.min_contribution;
    const auto renderer = compile(scene, scene.settings);
    const View view{0, 24, 18, {}, false};
    std::vector<PicturePoint> points;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) points.push_back({x + 0.5, y + 0.5});
    std::vector<Color> most(points.size());
    RayCounts counts;
    renderer->trace(view, points, deep, most, {}, counts);

    const Color light = accuracy::most_light(scene, accuracy::surfaces_beyond);
    for (const TraceLimits& limits :
         {TraceLimits{1, 1e-4}, TraceLimits{2, 1e-4}, TraceLimits{4, 1e-4}, TraceLimits{24, 0.03},
          TraceLimits{24, 0.3}}) {
        std::vector<Color> some(points.size());
        std::vector<Color> shares(points.size());
        renderer->trace(view, points, limits, some, {}, counts);
        renderer->cut_shares(view, points, limits, shares, {});
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Color lost = absolute(most[i] - some[i]);
            const auto expect_below = [&](double difference, double share, double most_light) {
                const double bound = share > 0 ? share * most_light : 0;
                ASSERT_LE(difference, bound + 1e-12)
                    << path << ", depth " << limits.max_depth << ", contribution "
                    << limits.min_contribution << ", pixel " << i;
            };
            expect_below(lost.x, shares[i].x, light.x);
            expect_below(lost.y, shares[i].y, light.y);
            expect_below(lost.z, shares[i].z, light.z);
        }
    }
}

TEST(CutBound, HoldsInEveryScene) {
    for_each_scene(expect_within_bound);
}

}  // namespace
}  // namespace lancer
