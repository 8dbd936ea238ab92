// The compiled world contains what the scene requires, and `lancer info` reports the same.
#include <random>

#include "tests/extremes/stage.h"
#include "tests/tracer/scene_kit.h"
#include "tracer/compile/compile.h"
#include "tracer/compile/primitive_bounds.h"

namespace lancer {
namespace {

using namespace kit;

/// A scene of a ball of this material beside an opaque one.
Scene ball_of(const Material& material) {
    Scene scene;
    scene.transforms = {{}};
    scene.materials = {Material{}};
    show(scene, Sphere{{3, 0, 0}, 1});
    show(scene, Sphere{{0, 0, 0}, 1}, material);
    return scene;
}

void expect_agreement(const Scene& scene) {
    const Requirements asked = requirements_of(scene, scene.settings);
    const auto world = compile_world<double>(scene, scene.settings);
    EXPECT_EQ(world->has_media, asked.needs(Feature::media));
    EXPECT_EQ(world->has_transmission, asked.needs(Feature::transmission));
    EXPECT_EQ(world->has_smooth_media, asked.needs(Feature::smooth_media));
    EXPECT_EQ(world->has_textures, asked.needs(Feature::textures));
    bool transmits = false;
    bool lists = false;
    for (const Primitive<double>& p : world->primitives) {
        transmits |= p.transmissive;
        lists |= p.medium && (p.transmissive || world->finishes[p.material].absorbs);
    }
    EXPECT_EQ(world->has_transmission, transmits);
    EXPECT_EQ(world->has_media, lists);
}

TEST(World, CarriesWhatTheSceneRequires) {
    expect_agreement(ball_of({}));
    expect_agreement(ball_of({.transmission = 1}));
    expect_agreement(ball_of({.transmission = 1, .ior = 1.5}));
    expect_agreement(ball_of({.ior = 1.5}));
    expect_agreement(ball_of({.absorption = {1, 0, 0}}));
    Scene sheet = ball_of({.filter = 0.5});
    sheet.objects[1].shape = Triangle{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
    expect_agreement(sheet);
}

TEST(World, AClearBodyOfIndexOneIsInTheListOfMedia) {
    const Scene scene = ball_of({.transmission = 1});
    EXPECT_TRUE(compile_world<double>(scene, scene.settings)->has_media);
    EXPECT_TRUE(requirements_of(scene, scene.settings).needs(Feature::media));
}

/// Turned, stretched and sheared at random.
Affine<double> turned_and_stretched(std::mt19937& random,
                                    std::uniform_real_distribution<double>& unit) {
    Affine<double> map;
    for (Vec3d& row : map.rows)
        row = Vec3d(unit(random), unit(random), unit(random)) * std::pow(10.0, unit(random));
    map.shift = Vec3d(unit(random), unit(random), unit(random)) * 10.0;
    return map;
}

/// The corners of rotated, stretched and sheared meshes, transformed to the world in a wider type.
template <class Real>
void expect_boxes_hold_their_meshes() {
    double all = 0;
    double of_corners = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        extremes::Stage s;
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(-1, 1);
        const Affine<double> map = turned_and_stretched(random, unit);
        Mesh mesh = extremes::icosphere(Vec3d(0, 2, 0), 1, static_cast<int>(seed % 4));
        for (Vec3d& v : mesh.vertices) v.z *= 0.1;
        s.add(mesh, s.matt({1, 1, 1}), map);
        const auto world = compile_world<Real>(s.scene, s.scene.settings);
        const Primitive<Real>& p = world->primitives.front();
        const Bounds<Real> box = box_in_tree(*world, p);
        const auto to_world = convert<long double>(world->frames[p.frame].to_world);
        for (const Vec3<Real>& v : std::get<MeshInstance<Real>>(p.solid).mesh->vertices) {
            const Vec3<long double> place = map_point(to_world, convert<long double>(v));
            for (int i = 0; i < 3; ++i) {
                EXPECT_GE(place[i], box.min[i]) << "seed " << seed;
                EXPECT_LE(place[i], box.max[i]) << "seed " << seed;
            }
        }
        all += static_cast<double>(half_area(box));
        of_corners += static_cast<double>(half_area(bounds_of(*world, p)));
    }
    EXPECT_LT(all, 0.85 * of_corners);
}

/// The same for rings, with points all over each.
template <class Real>
void expect_boxes_hold_their_rings() {
    double all = 0;
    double of_corners = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        extremes::Stage s;
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(-1, 1);
        const Affine<double> map = turned_and_stretched(random, unit);
        s.add(Torus{1.5, 1.5 * std::pow(10.0, 3 * unit(random) - 3)}, s.matt({1, 1, 1}), map);
        const auto world = compile_world<Real>(s.scene, s.scene.settings);
        const Primitive<Real>& p = world->primitives.front();
        const Bounds<Real> box = box_in_tree(*world, p);
        const auto& torus = std::get<TorusSolid<Real>>(p.solid);
        const auto to_world = convert<long double>(world->frames[p.frame].to_world);
        const long double ring = torus.ring * torus.grow;
        const long double tube = torus.tube * torus.grow;
        std::uniform_real_distribution<long double> angle(0, 6.2831853L);
        Vec3<long double> low(1e30L);
        Vec3<long double> high(-1e30L);
        for (int i = 0; i < 4000; ++i) {
            const long double around = angle(random);
            const long double round = angle(random);
            const long double away = ring + tube * std::cos(round);
            const Vec3<long double> place = map_point(
                to_world,
                {away * std::cos(around), tube * std::sin(round), away * std::sin(around)});
            for (int a = 0; a < 3; ++a) {
                low[a] = std::min(low[a], place[a]);
                high[a] = std::max(high[a], place[a]);
            }
        }
        for (int a = 0; a < 3; ++a) {
            EXPECT_GE(low[a], box.min[a]) << "seed " << seed;
            EXPECT_LE(high[a], box.max[a]) << "seed " << seed;
            EXPECT_LT(box.max[a] - box.min[a], (high[a] - low[a]) * 1.1L) << "seed " << seed;
        }
        all += static_cast<double>(half_area(box));
        of_corners += static_cast<double>(half_area(bounds_of(*world, p)));
    }
    EXPECT_LT(all, 0.75 * of_corners);
}

TEST(World, TheBoxOfATurnedRingHoldsIt) {
    expect_boxes_hold_their_rings<float>();
    expect_boxes_hold_their_rings<double>();
    expect_boxes_hold_their_rings<long double>();
}

TEST(World, TheBoxOfATurnedMeshHoldsIt) {
    expect_boxes_hold_their_meshes<float>();
    expect_boxes_hold_their_meshes<double>();
    expect_boxes_hold_their_meshes<long double>();
}

}  // namespace
}  // namespace lancer
