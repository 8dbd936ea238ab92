// Ray trees of every scene of scenes/: they describe the picture itself, and are complete.
#include <gtest/gtest.h>

#include "tests/scenes/every_scene.h"
#include "tracer/ray_tree_renderer.h"

namespace lancer {
namespace {

Color behind(const Scene& scene, const Vec3d& direction) {
    if (!scene.sky) return scene.background;
    const auto& stops = scene.sky->stops;
    const double cosine = dot(normalize(scene.sky->axis), normalize(direction));
    std::size_t next = 0;
    while (next < stops.size() && stops[next].at <= cosine) ++next;
    if (next == 0) return stops.front().color;
    if (next == stops.size()) return stops.back().color;
    const double share = (cosine - stops[next - 1].at) / (stops[next].at - stops[next - 1].at);
    return (1 - share) * stops[next - 1].color + share * stops[next].color;
}

/// The sum of the light that the surfaces and backgrounds of a tree send, with its weights.
Color sum_of(const RayTree& tree, const Scene& scene) {
    Color sum(0);
    for (const RayTree::Ray& ray : tree.rays) {
        for (const RayTree::Contact& contact : ray.contacts)
            for (const RayTree::Surface& surface : contact.surfaces)
                sum += surface.weight * surface.own;
        if (ray.end == RayTree::End::background) sum += ray.share * behind(scene, ray.direction);
    }
    return sum;
}

/// Every ray except the first has exactly one parent, which precedes it.
void expect_a_tree(const RayTree& tree) {
    std::vector<int> named(tree.rays.size(), 0);
    for (std::uint32_t i = 0; i < tree.rays.size(); ++i) {
        const auto name = [&](std::uint32_t next) {
            if (next == none) return;
            ASSERT_LT(next, tree.rays.size());
            EXPECT_GT(next, i);
            ++named[next];
        };
        const RayTree::Ray& ray = tree.rays[i];
        for (const RayTree::Contact& contact : ray.contacts) {
            name(contact.bent);
            EXPECT_FALSE(contact.hits.empty());
            for (const RayTree::Surface& surface : contact.surfaces) name(surface.mirrored);
        }
        const bool bends = !ray.contacts.empty() && ray.contacts.back().bent != none;
        EXPECT_EQ(ray.end == RayTree::End::open, bends);
    }
    for (std::uint32_t i = 1; i < named.size(); ++i) EXPECT_EQ(named[i], 1) << i;
}

void expect_trees_of_the_picture(const Scene& scene, const std::string& path) {
    const auto renderer = compile_for_ray_trees(scene, scene.settings);
    const View view{0, 24, 18, {}, false};
    RayCounts counts;
    const Image image = compile(scene, scene.settings)->render(view, {}, counts);
    for (int y = 1; y < view.height; y += 4) {
        for (int x = 1 + y / 4 % 2; x < view.width; x += 5) {
            const std::vector<PicturePoint> points = renderer->samples(x, y);
            Color sum(0);
            for (const PicturePoint& at : points) {
                const RayTree tree = renderer->ray_tree(view, at);
                ASSERT_FALSE(tree.is_cut) << path;
                expect_a_tree(tree);
                const Color told = sum_of(tree, scene);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(told[c], tree.color[c], 1e-12 * (1 + std::abs(tree.color[c])))
                        << path << " at " << at.x << "," << at.y;
                sum += tree.color;
            }
            const double rays = static_cast<double>(points.size());
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(points.size() == 1 ? sum[c] : sum[c] / rays, image.pixel(x, y)[c])
                    << path << " at " << x << "," << y;
        }
    }
}

TEST(RayTree, HasTheBytesOfThePicture) {
    const int scenes = for_each_scene(expect_trees_of_the_picture);
    EXPECT_GT(scenes, 50);
}

TEST(RayTree, SamplesAreThoseOfThePixel) {
    cli::Session session;
    Scene scene =
        cli::SceneLoader(LANCER_SOURCE_DIR "/scenes/glass/refraction.lancer", {}, session).load();
    scene.settings.samples = 3;
    for (const Sampling sampling : {Sampling::grid, Sampling::sobol}) {
        scene.settings.sampling = sampling;
        expect_trees_of_the_picture(scene, "refraction");
    }
}

}  // namespace
}  // namespace lancer
