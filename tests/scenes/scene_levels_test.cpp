// Every scene of scenes/ on every level of rays side by side: the same bytes and counts.
#include <filesystem>

#include "cli/scene_loader.h"
#include "tests/tracer/supported_levels.h"

namespace lancer {
namespace {

namespace fs = std::filesystem;

TEST(SceneLevels, ScenesOfTheCollectionAreTheSame) {
    int wide = 0;
    for (const auto& entry : fs::recursive_directory_iterator(LANCER_SOURCE_DIR "/scenes")) {
        const std::string path = entry.path().string();
        if (entry.path().extension() != ".lancer" || path.find("/bad/") != std::string::npos)
            continue;
        cli::Session session;
        Scene scene = cli::SceneLoader(path, {}, session).load();
        scene.settings.samples = 1;
        wide += expect_same_on_all_levels(scene, path, {0, 56, 42, {}, false});
    }
    EXPECT_GE(wide, supported_wide_levels().empty() ? 0 : 20) << "too few went side by side";
}

}  // namespace
}  // namespace lancer
