// Every scene of scenes/ on every level of rays side by side: the same bytes and counts.
#include "tests/scenes/every_scene.h"
#include "tests/tracer/supported_levels.h"

namespace lancer {
namespace {

TEST(SceneLevels, ScenesOfTheCollectionAreTheSame) {
    int wide = 0;
    for_each_scene([&](const Scene& scene, const std::string& path) {
        wide += expect_same_on_all_levels(scene, path, {0, 56, 42, {}, false});
    });
    EXPECT_GE(wide, supported_wide_levels().empty() ? 0 : 20) << "too few went side by side";
}

}  // namespace
}  // namespace lancer
