// The guarantee of a tolerance, for all tolerances, the teapot and patches of any size. Slow.
#include <gtest/gtest.h>

#include <cstdio>

#include "model/io/file.h"
#include "parser/parse.h"
#include "tests/tracer/splines/fewest_grid.h"
#include "tests/tracer/splines/random_patch.h"
#include "tracer/tessellation/tessellate.h"

namespace lancer::splines {
namespace {

constexpr std::size_t enough = 20000;  ///< triangles to sample

/// The largest sampled distance as a share of the tolerance.
double worst_share(const Patch& patch, double tolerance) {
    const auto mesh = tessellate(patch, tolerance);
    if (!mesh) return 0;
    EXPECT_FALSE(mesh->faces.empty());
    // An odd stride, so that not every second triangle of a cell is left out.
    const std::size_t every = mesh->faces.size() / enough | 1;
    return static_cast<double>(measured_distance(patch, *mesh, 5, every) / tolerance);
}

std::vector<Patch> teapot() {
    const std::string path = std::string(LANCER_SOURCE_DIR) + "/scenes/gallery/teapot.lancer";
    SourceMap sources;
    std::vector<Diagnostic> found;
    const Script script = parse_script(path, io::read_file(path), {}, sources, found);
    return evaluate(script, {}, {}, sources, found, disk_loader()).scene.patches;
}

/// The number of triangles as a multiple of that of the smallest uniform grid.
double share_of_fewest(const Patch& patch, double tolerance) {
    const auto mesh = tessellate(patch, tolerance);
    if (!mesh) return 0;
    UniformGrids grids(bezier_net(patch).patch(0, 0), tolerance);
    return static_cast<double>(mesh->faces.size()) /
           static_cast<double>(grids.fewest(mesh->faces.size()));
}

class Tolerance : public testing::TestWithParam<double> {};

TEST_P(Tolerance, RandomPatchesAreWithinItAtAnyScale) {
    double worst = 0;
    for (unsigned seed = 0; seed < 4; ++seed) {
        for (const double factor : {1.0, 1e9, 1e-9}) {
            const Patch patch = random_patch_from_corner(seed, factor, seed % 2 == 0 ? 1 : 0.1);
            const double share = worst_share(patch, GetParam() * factor);
            EXPECT_LE(share, 1) << seed << " " << factor;
            worst = std::max(worst, share);
        }
    }
    EXPECT_GT(worst, 0.3);  // otherwise the measurement is wrong, or the mesh far too fine
}

TEST_P(Tolerance, TheTeapotIsWithinIt) {
    const std::vector<Patch> patches = teapot();
    ASSERT_EQ(patches.size(), 32u);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        // The finest tolerances take long, so only every fourth patch is tested: one of each part
        // of the teapot.
        if (GetParam() < 1e-3 && i % 4 != 0) continue;
        EXPECT_LE(worst_share(patches[i], GetParam()), 1) << i;
    }
}

TEST_P(Tolerance, TakesAtMostTwiceTheTrianglesOfTheCoarsestUniformGrid) {
    double worst = 0;
    const auto look = [&](const Patch& patch, double tolerance, const std::string& name) {
        const double share = share_of_fewest(patch, tolerance);
        EXPECT_LE(share, 2) << name;
        worst = std::max(worst, share);
    };
    const std::vector<Patch> patches = teapot();
    for (std::size_t i = 0; i < patches.size(); i += GetParam() < 1e-3 ? 4 : 1)
        look(patches[i], GetParam(), "teapot " + std::to_string(i));
    for (unsigned seed = 0; seed < (GetParam() < 1e-3 ? 2 : 6); ++seed) {
        for (const double factor : {1.0, 1e9, 1e-9}) {
            look(random_patch_from_corner(seed, factor, seed % 2 == 0 ? 1 : 0.1),
                 GetParam() * factor, "random " + std::to_string(seed));
        }
    }
    EXPECT_GT(worst, 0.8);  // otherwise the grids are judged too severely
    std::printf("at most %.2f times the fewest\n", worst);
}

INSTANTIATE_TEST_SUITE_P(Tens, Tolerance, testing::Values(1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6));

}  // namespace
}  // namespace lancer::splines
