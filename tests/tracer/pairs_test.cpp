// The tracer against three pictures that POV-Ray made from scenes written by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/io/image_file.h"
#include "tests/reference/pov/pair_scenes.h"
#include "tracer/render.h"

namespace lancer {
namespace {

Image stored(const std::string& name) {
    return io::read_image(LANCER_SOURCE_DIR "/tests/pairs/" + name + ".png",
                          io::ColorSpace::linear);
}

Image rendered(const Scene& scene) {
    RayCounts counts;
    return compile(scene, scene.settings)->render({0, 160, 120, {}, false}, {}, counts);
}

double clipped(double x) {
    return std::clamp(x, 0.0, 1.0);
}

/// Pixels off by more than `bound` in a channel whose neighbourhood is smooth in POV-Ray's picture:
/// an edge through a pixel's centre may go either way.
int wrong_off_edges(const Image& ours, const Image& theirs, double bound) {
    const auto differs = [&](int x, int y) {
        double most = 0;
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(clipped(ours.pixel(x, y)[c]) - theirs.pixel(x, y)[c]));
        return most > bound;
    };
    const auto near_edge = [&](int x, int y) {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const int nx = std::clamp(x + dx, 0, theirs.width - 1);
                const int ny = std::clamp(y + dy, 0, theirs.height - 1);
                for (int c = 0; c < 3; ++c) {
                    if (std::abs(theirs.pixel(nx, ny)[c] - theirs.pixel(x, y)[c]) > 0.1)
                        return true;
                }
            }
        }
        return false;
    };
    int wrong = 0;
    for (int y = 0; y < ours.height; ++y) {
        for (int x = 0; x < ours.width; ++x) wrong += differs(x, y) && !near_edge(x, y);
    }
    return wrong;
}

TEST(Pairs, SolidsAgreeWithPovRayOffTheEdges) {
    EXPECT_EQ(wrong_off_edges(rendered(reference::solids_scene()), stored("solids"), 2e-5), 0);
}

TEST(Pairs, NestedGlassAgreesWithPovRayOffTheEdges) {
    EXPECT_EQ(
        wrong_off_edges(rendered(reference::glass_nested_scene()), stored("glass_nested"), 2e-5),
        0);
}

TEST(Pairs, PlanarTexturesAgreeWithPovRayOffTheEdges) {
    EXPECT_EQ(wrong_off_edges(rendered(reference::tex_planar_scene()), stored("tex_planar"), 2e-5),
              0);
}

}  // namespace
}  // namespace lancer
