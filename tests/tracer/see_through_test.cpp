// Light through transparent things found by one search is the same, bit for bit, as when found
// contact by contact.
#include <random>

#include "tests/tracer/scene_kit.h"
#include "tracer/compile/compile.h"
#include "tracer/shading/shadow.h"

namespace lancer {
namespace {

using namespace kit;

struct Random {
    std::mt19937_64 engine;

    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    bool chance(double share) { return (*this)(0, 1) < share; }
    Vec3d place(double size) {
        const double x = (*this)(-size, size);
        const double y = (*this)(-size, size);
        return {x, y, (*this)(-size, size)};
    }
};

Material filter(Random& random) {
    Material m;
    m.color = {random(0.2, 1), random(0.2, 1), random(0.2, 1)};
    m.transmission = random(0, 0.5);
    m.filter = random(0.1, 0.5);
    m.ior = random.chance(0.3) ? 1 : random(1.1, 1.6);
    if (random.chance(0.1)) m.absorption = {0.1, 0.2, 0.3};
    return m;
}

Shape any_shape(Random& random) {
    const Vec3d at = random.place(3);
    const double size = random(0.2, 1.5);
    switch (static_cast<int>(random(0, 6))) {
        case 0:
            return Box{at, at + Vec3d(size, size / 2, size)};
        case 1:
            return Cylinder{at, at + random.place(1.5), size / 2, random.chance(0.7)};
        case 2:
            return Cone{at, at + random.place(1.5), size / 2, size / 5, true};
        case 3:
            return Triangle{{at, at + random.place(2), at + random.place(2)}};
        default:
            return Sphere{at, size};
    }
}

/// A dozen bodies and sheets, many of them in each other, and a few that touch by intent.
Scene glass_scene(Random& random) {
    Scene scene;
    scene.transforms = {{}};
    for (int i = 0; i < 12; ++i) {
        Material m = filter(random);
        if (random.chance(0.1)) m.transmission = m.filter = 0;
        const Affine<double> map =
            random.chance(0.3) ? in_turn(stretched(1, random(0.5, 2), 1), turn_y(random(0, 360)))
                               : Affine<double>{};
        Object& object = show(scene, any_shape(random), m, map);
        object.casts_shadow = !random.chance(0.1);
    }
    show(scene, Sphere{{0, 0, 0}, 1}, filter(random));
    show(scene, Box{{-1, 1, -1}, {1, 2, 1}}, filter(random));
    show(scene, Sphere{{0, 0, 0}, 0.5}, filter(random));
    if (random.chance(0.3)) show(scene, Plane{{0, 1, 0}, -2}, filter(random));
    return scene;
}

/// Where a camera ray first meets something, and what is around it there.
struct ShadowRay {
    Ray<double> ray;
    Start<double> start;
    Media media;
    double distance;
};

std::optional<ShadowRay> shadow_ray(const World<double>& world, Random& random) {
    const Vec3d eye = random.place(4);
    const Ray<double> ray = make_ray(eye, Vec3d(0.0), normalize(random.place(1)), 0.0);
    CameraMedia<double> origins;
    const Media media = origins.around(world, ray);
    Contact<double> contact = nearest_contact(world, ray, Start<double>{0}, media.bodies);
    if (contact.empty()) return std::nullopt;
    order_contact(world, contact);
    const Media after = crossed(world, media, contact);
    const Surface<double> s = make_surface(world, ray, contact.front());
    SurfaceList touched;
    for (const Hit<double>& hit : contact) touched.push_back(hit.surface);
    const Vec3d way = random.place(6) - s.position;
    const double distance = length(way);
    const Vec3d direction = way / distance;
    const bool back = (dot(s.geometric, direction) > 0) != (dot(s.geometric, ray.dir) > 0);
    return ShadowRay{make_ray(s.position, s.position_lo, direction, s.error),
                     {0, touched, left_for_good(s, direction)},
                     back ? media : after,
                     random.chance(0.2) ? std::numeric_limits<double>::infinity() : distance};
}

TEST(SeeThrough, GivesTheSameBitsAsFromContactToContact) {
    Random random{std::mt19937_64(3)};
    int told = 0;
    int filtered = 0;
    int different = 0;
    for (int k = 0; k < 400; ++k) {
        const Scene scene = glass_scene(random);
        const auto world = compile_world<double>(scene, scene.settings);
        for (int i = 0; i < 2000; ++i) {
            const auto at = shadow_ray(*world, random);
            if (!at) continue;
            SeeThrough<double> see_through(*world, at->distance);
            const Occlusion occlusion = query_occlusion(*world, at->ray, at->distance, at->start,
                                                        at->media.bodies, &see_through)
                                            .occlusion;
            const Occlusion plain =
                query_occlusion(*world, at->ray, at->distance, at->start, at->media.bodies)
                    .occlusion;
            EXPECT_EQ(occlusion == Occlusion::blocked, plain == Occlusion::blocked);
            if (plain == Occlusion::blocked) continue;
            ++filtered;
            if (!see_through.tells_all(at->start, at->media.bodies)) continue;
            ++told;
            const Vec3d one = see_through.transmittance(at->media.bodies);
            const Vec3d many =
                light_by_contacts(*world, at->ray, at->distance, at->start, at->media, true);
            different += one != many;
        }
    }
    EXPECT_GT(filtered, 50000);
    EXPECT_GT(told, filtered / 2);
    EXPECT_EQ(different, 0) << "of " << told;
}

}  // namespace
}  // namespace lancer
