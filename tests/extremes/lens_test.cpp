// A lens made from two balls: near its axis, it follows the lensmaker's equation.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/extremes/stage.h"
#include "tracer/ray_tree_renderer.h"

namespace lancer::extremes {
namespace {

/// The distance, behind its last surface, at which a ray that enters parallel to the axis at the
/// height h crosses the axis.
double focal_distance(double front, double back, double thick, double ior, double h) {
    Stage s;
    const std::uint32_t glass = s.glass(ior);
    s.add_body(Composite::Kind::intersect,
               {{Sphere{{0, 0, thick / 2 - front}, front}, glass, {}},
                {Sphere{{0, 0, back - thick / 2}, back}, glass, {}}},
               glass);
    s.look_parallel({h, 0, 10}, {h, 0, 0}, 1);
    const auto renderer = compile_for_ray_trees(s.scene, s.scene.settings);
    View view;
    view.width = view.height = 1;
    const RayTree tree = renderer->ray_tree(view, {0.5, 0.5});
    EXPECT_EQ(tree.rays.size(), 3u) << "in, through the glass, out";
    const RayTree::Ray& out = tree.rays.back();
    const double t = -out.origin.x / out.direction.x;
    return -thick / 2 - (out.origin.z + t * out.direction.z);
}

TEST(Lens, OfTwoBallsHasTheFocalLengthOfTheLensmaker) {
    struct Case {
        double front, back, thick, ior;
    };
    for (const Case c : {Case{1, 1, 0.25, 1.5}, Case{2, 1, 0.5, 1.5}, Case{1, 3, 0.125, 1.9},
                         Case{5, 4, 0.01, 1.33}, Case{1, 1, 0.5, 2.4}}) {
        const long double n = c.ior, r1 = c.front, r2 = -static_cast<long double>(c.back),
                          d = c.thick;
        const long double power = (n - 1) * (1 / r1 - 1 / r2 + (n - 1) * d / (n * r1 * r2));
        const long double expected = (1 - (n - 1) * d / (n * r1)) / power;
        // The remaining error at this height is the spherical aberration, below h^2.
        const double found = focal_distance(c.front, c.back, c.thick, c.ior, 1e-8);
        EXPECT_NEAR(static_cast<double>(found / expected), 1, 1e-12)
            << c.front << ' ' << c.back << ' ' << c.ior;
    }
}

}  // namespace
}  // namespace lancer::extremes
