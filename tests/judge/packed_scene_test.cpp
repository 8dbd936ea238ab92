// A packed scene shows the same as the scene, also without textures and smooth normals.
#include "judge/pack/packed_scene.h"

#include <gtest/gtest.h>

#include "judge/validate/validate.h"
#include "tests/scenes/every_scene.h"
#include "tracer/render.h"

namespace lancer::judge {
namespace {

std::vector<double> shown(const Scene& scene) {
    RayCounts counts;
    const View view{0, 24, 18, {}, false};
    return compile(scene, scene.settings)->render(view, {}, counts).data;
}

TEST(PackedScene, ShowsTheSameWithoutTexturesAndNormals) {
    int changed = 0;
    for_each_scene([&](Scene& scene, const std::string& path) {
        prepare_for_validation(scene);
        const std::vector<double> before = shown(scene);
        scene.settings.textures = scene.settings.smooth = false;
        std::vector<Diagnostic> warnings;
        const Scene packed = as_packed(scene, warnings);
        EXPECT_TRUE(packed.settings.textures && packed.settings.smooth) << path;
        if (!warnings.empty()) return;  // true surfaces replace triangles
        const std::vector<double> plain = shown(scene);
        EXPECT_EQ(shown(packed), plain) << path;
        changed += plain == before ? 0 : 1;
    });
    EXPECT_GE(changed, 15) << "too few have textures or smooth normals";
}

}  // namespace
}  // namespace lancer::judge
