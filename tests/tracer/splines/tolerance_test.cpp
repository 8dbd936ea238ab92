// The promise of a tolerance, for all tolerances, the teapot and patches of any size. Slow.
#include <gtest/gtest.h>

#include "model/io/file.h"
#include "parser/parse.h"
#include "tests/tracer/splines/mesh_distance.h"
#include "tracer/splines/tessellate.h"

namespace lancer::splines {
namespace {

constexpr std::size_t enough = 60000;  ///< triangles to sample

/// The worst sampled distance, in parts of the tolerance.
double worst_share(const Patch& patch, double tolerance) {
    const auto mesh = tessellate(patch, tolerance);
    if (!mesh) return 0;
    EXPECT_FALSE(mesh->faces.empty());
    // An odd stride, so that not every second triangle of a cell is left out.
    const std::size_t every = mesh->faces.size() / enough | 1;
    return static_cast<double>(measured_distance(patch, *mesh, 5, every) / tolerance);
}

class Tolerance : public testing::TestWithParam<double> {};

TEST_P(Tolerance, RandomPatchesAreWithinItAtAnyScale) {
    double worst = 0;
    for (unsigned seed = 0; seed < 4; ++seed) {
        for (const double factor : {1.0, 1e9, 1e-9}) {
            const Patch patch = random_patch(seed, factor, seed % 2 == 0 ? 1 : 0.1);
            const double share = worst_share(patch, GetParam() * factor);
            EXPECT_LE(share, 1) << seed << " " << factor;
            worst = std::max(worst, share);
        }
    }
    EXPECT_GT(worst, 0.3);  // else it would be measured wrongly, or far too fine
}

TEST_P(Tolerance, TheTeapotIsWithinIt) {
    const std::string path = std::string(LANCER_SOURCE_DIR) + "/scenes/gallery/teapot.lancer";
    SourceMap sources;
    std::vector<Diagnostic> found;
    const Script script = parse_script(path, io::read_file(path), {}, sources, found);
    const Scene scene = evaluate(script, {}, {}, sources, found, disk_loader()).scene;
    ASSERT_EQ(scene.patches.size(), 32u);
    for (std::size_t i = 0; i < scene.patches.size(); ++i) {
        // The finest take long: a quarter of the patches then, of each part of it one.
        if (GetParam() < 1e-3 && i % 4 != 0) continue;
        EXPECT_LE(worst_share(scene.patches[i], GetParam()), 1) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Tens, Tolerance, testing::Values(1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6));

}  // namespace
}  // namespace lancer::splines
