// Where a scene stands, and from how far it is seen, must not matter.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

TEST(Translation, RepresentableCoordinatesAreBitIdentical) {
    const Scene scene = base_stage().scene;
    const Image reference = picture(scene);
    for (int k = 0; k <= 12; ++k)
        EXPECT_EQ(different(picture(moved(scene, Vec3d(power10(k)))), reference), 0) << k;
    for (int k = 0; k <= 40; k += 4)
        EXPECT_EQ(different(picture(moved(scene, Vec3d(std::ldexp(1.0, k)))), reference), 0) << k;
}

TEST(Translation, AnyCoordinates) {
    // A third of the scene: no number is representable, and adding 10^k rounds them all.
    const Scene scene = scaled(base_stage().scene, 1.0 / 3);
    const Image reference = picture(scene);
    for (int k = 0; k <= 9; ++k)
        EXPECT_EQ(wrong(picture(moved(scene, Vec3d(power10(k)))), reference), 0) << k;
    for (int k = 10; k <= 12; ++k)
        EXPECT_LE(wrong(picture(moved(scene, Vec3d(power10(k)))), reference), 12) << k;
}

Scene seen_from(Scene scene, const Vec3d& towards, double distance, double height) {
    Stage s;
    s.scene = std::move(scene);
    if (distance == 0) {
        s.look_parallel(towards * 8.0, {0, 0.75, 0}, height);
    } else {
        const Vec3d at(0, 0.75, 0);
        s.look(at + towards * distance, at, degrees(2 * std::atan(height / 2 / distance)));
    }
    return s.scene;
}

TEST(Camera, FarAwayIsParallel) {
    for (const Vec3d& towards :
         {normalize(Vec3d(0.05, 0.55, 0.8)), normalize(Vec3d(0.3, 0.45, 0.8))}) {
        const Scene scene = base_stage().scene;
        Stage parallel{};
        parallel.scene = scene;
        parallel.look_parallel(Vec3d(0, 0.75, 0) + towards * 8.0, {0, 0.75, 0}, 4);
        const Image reference = picture(parallel.scene);
        for (int k = 6; k <= 13; ++k) {
            const int bad = wrong(picture(seen_from(scene, towards, power10(k), 4)), reference);
            EXPECT_LE(bad, k <= 11 ? 0 : k == 12 ? 4 : 245) << "k " << k << " z " << towards.z;
        }
    }
}

/// Ground of radius 10^k under the objects, against the plane.
Stage on_ground(const Shape& ground) {
    Stage s = base_stage();
    s.scene.objects[0].shape = ground;
    return s;
}

TEST(GiantSphere, WithObjectsIsThePlane) {
    Stage flat = on_ground(Plane{{0, 1, 0}, 0});
    flat.look({0.5, 2.75, 6.25}, {0, 0.25, 0}, 40);
    for (int k = 7; k <= 15; ++k) {
        Stage round = on_ground(Sphere{{0, -power10(k), 0}, power10(k)});
        // From above, so that no horizon is seen.
        for (Stage* s : {&flat, &round}) s->look({0.5, 6, 2}, {0, 0, 0}, 45);
        EXPECT_LE(wrong(picture(round.scene), picture(flat.scene)), k <= 12 ? 0 : 3) << k;
    }
}

TEST(GiantSphere, AloneAgreesWithMoreDigits) {
    for (int k = 1; k <= 15; ++k) {
        Stage s;
        s.look({0, 2, 0}, {0, 0, -5}, 45);
        s.lamp({4, 6, 3});
        s.scene.background = {0.1, 0.2, 0.4};
        s.add(Sphere{{0, -power10(k), 0}, power10(k)}, s.matt({0.9, 0.9, 0.8}));
        EXPECT_EQ(wrong(picture(s.scene), picture(s.scene, Precision::extended)), 0) << k;
    }
}

}  // namespace
}  // namespace lancer::extremes
