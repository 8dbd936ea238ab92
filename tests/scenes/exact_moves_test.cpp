// A move that changes no digit of the coordinates changes no bit of the picture.
#include <gtest/gtest.h>

#include "cli/scene_loader.h"
#include "tracer/render.h"

namespace lancer {
namespace {

Image moved_by(const std::string& scene_name, const std::string& d, Level level) {
    cli::Session session;
    cli::SceneOptions options;
    options.definitions.emplace_back("d", d);
    const std::string path = LANCER_SOURCE_DIR "/scenes/" + scene_name;
    const Scene scene = cli::SceneLoader(path, options, session).load();
    RayCounts rays;
    return compile(scene, scene.settings, level)
        ->render({0, scene.width, scene.height, {}, false}, {}, rays);
}

void expect_equal_bits(const std::string& scene_name) {
    for (const Level level : {Level::scalar, Level::avx2, Level::avx512}) {
        if (!is_supported(level)) continue;
        const Image image = moved_by(scene_name, "0", level);
        for (const char* d : {"1000", "1e8", "1e11", "1e12", "16777216", "30000000000000"})
            EXPECT_TRUE(moved_by(scene_name, d, level).data == image.data)
                << d << ' ' << name_of(level);
    }
}

TEST(ExactMoves, OfGlassAndFacetsChangeNoBit) {
    expect_equal_bits("media/moved.lancer");
}

TEST(ExactMoves, OfTexturesOnTurnedShapesChangeNoBit) {
    expect_equal_bits("textures/moved.lancer");
}

}  // namespace
}  // namespace lancer
