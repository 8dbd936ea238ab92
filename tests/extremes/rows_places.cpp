#include <cmath>

#include "tests/extremes/random_scene.h"
#include "tests/extremes/rows.h"
#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

Scene base(int) {
    return base_stage().scene;
}

/// A third of the scene: no number of it is representable, and adding 10^k rounds them all.
Scene thirds(int) {
    return scaled(base_stage().scene, 1.0 / 3);
}

Scene glass_mesh(int k) {
    Stage s;
    s.look({0.5, 2.5, 5}, {0, 1, 0}, 35);
    s.lamp({4, 6, 3});
    s.scene.background = {0.1, 0.2, 0.4};
    s.add(Plane{{0, 1, 0}, 0}, s.matt({0.9, 0.9, 0.8}));
    s.add(Box{{-2, 0, -2}, {-1, 1, -1}}, s.matt({0.9, 0.2, 0.1}));
    s.add(icosphere({0, 1, 0}, 1, 2), s.glass(1.5));
    return scaled(s.scene, power10(k));
}

Scene seen_along(const Vec3d& towards, std::optional<int> k) {
    constexpr double height = 4;
    const Vec3d at(0, 0.75, 0);
    Stage s = base_stage();
    if (!k)
        s.look_parallel(at + towards * 8.0, at, height);
    else
        s.look(at + towards * power10(*k), at, degrees(2 * std::atan(height / 2 / power10(*k))));
    return s.scene;
}

/// From above, so that no horizon is seen.
Scene on_ground(const Shape& ground) {
    Stage s = base_stage();
    s.scene.objects[0].shape = ground;
    s.look({0.5, 6, 2}, {0, 0, 0}, 45);
    return s.scene;
}

Scene ground_alone(int k) {
    Stage s;
    s.look({0, 2, 0}, {0, 0, -5}, 45);
    s.lamp({4, 6, 3});
    s.scene.background = {0.1, 0.2, 0.4};
    s.add(Sphere{{0, -power10(k), 0}, power10(k)}, s.matt({0.9, 0.9, 0.8}));
    return s.scene;
}

/// A house on a planet: 10^7 down to glass of 10^-6 in one picture. k = 1: the drop seen near by.
Scene many_sizes(double x, int k) {
    Stage s;
    const Vec3d at(x, x / 3, -x / 7);
    s.scene.background = {0.1, 0.2, 0.4};
    s.lamp(at + Vec3d(4, 6, 3));
    s.add(Sphere{at + Vec3d(0, -1e7, 0), 1e7}, s.matt({0.3, 0.8, 0.3}));
    s.add(Box{at + Vec3d(-1, 0, -1), at + Vec3d(1, 1.5, 1)}, s.matt({0.9, 0.8, 0.7}));
    s.add(Box{at + Vec3d(-0.5, 0.25, 1.25), at + Vec3d(0.5, 1, 1.25 + 1e-6)},
          s.glass(1.5, {0.5, 0.9, 0.9}));
    s.add(Sphere{at + Vec3d(1e-6, 0.5, 1.5), 2e-6}, s.matt({1, 0, 0}));
    s.add(Cylinder{at + Vec3d(1.5, 0, 1.5), at + Vec3d(1.5, 1, 1.5), 1e-2}, s.mirror());
    if (k == 0)
        s.look(at + Vec3d(1, 2, 5), at + Vec3d(0, 0.75, 0), 40);
    else
        s.look(at + Vec3d(0, 0.5, 1.5 + 2e-5), at + Vec3d(0, 0.5, 1.5), 40);
    return s.scene;
}

/// Objects written tiny or huge along one axis and stretched back.
Scene stretched_back(int k) {
    const double f = power10(k);
    Stage s = base_stage();
    for (Object& o : s.scene.objects) {
        Affine<double> map = stretched(1, f, 1);
        if (auto* box = std::get_if<Box>(&o.shape)) {
            box->min.y /= f;
            box->max.y /= f;
        } else if (auto* ref = std::get_if<MeshRef>(&o.shape)) {
            Mesh mesh = *s.scene.meshes[ref->mesh];
            for (Vec3d& v : mesh.vertices) v.y /= f;
            s.scene.meshes[ref->mesh] = std::make_shared<Mesh>(mesh);
        } else {
            // What cannot be written unevenly is stretched twice, as by two groups.
            map = compose(stretched(1, 1 / f, 1), stretched(1, f, 1));
        }
        o.transform = static_cast<std::uint32_t>(s.scene.transforms.size());
        s.scene.transforms.push_back(map);
    }
    return s.scene;
}

Scene nested_groups(int count) {
    Affine<double> map;
    for (int i = 0; i < count; ++i)
        map = compose(compose(turn(i % 3, 11.0 * i), shift(Vec3d(0.1 * i, -1, 0.3))), map);
    return under(base_stage().scene, map);
}

}  // namespace

std::vector<Row> rows_of_places() {
    std::vector<Row> rows;
    const auto add = [&](Row row) { rows.push_back(std::move(row)); };
    Row row;
    row.name = "size times 2ᵏ: pixels with another bit";
    row.ks = {-100, -60, -30, -20, -10, -8, -4, -1, 0, 1, 4, 8, 10, 12, 20, 30, 60, 100};
    row.scene = [](int k) { return scaled(base(0), std::ldexp(1.0, k)); };
    row.same_as = base;
    row.bits = true;
    row.allowed = none_wrong(-100, 100);
    row.asked = "0, \\|k\\| ≤ 100";
    row.tachyon = row.plotted = true;
    add(row);

    row = {};
    row.name = "size times 10ᵏ";
    row.ks = {-250, -100, -90, -30, -12, -9, -8, -7, -6, -5, -4, -3, -2,  -1, 0,
              1,    2,    3,   4,   5,   6,  7,  8,  9,  12, 30, 90, 100, 250};
    row.scene = [](int k) { return scaled(base(0), power10(k)); };
    row.same_as = base;
    row.allowed = none_wrong(-100, 100);
    row.asked = "0, \\|k\\| ≤ 9; aim 100";
    row.tachyon = true;
    add(row);

    row = {};
    row.name = "glass mesh, size times 10ᵏ";
    row.ks = ks_from(-9, 9);
    row.scene = glass_mesh;
    row.exactly_as = [](int) { return glass_mesh(0); };
    row.steady = true;
    row.allowed = none_wrong(-9, 9);
    row.asked = "0, \\|k\\| ≤ 9";
    row.plotted = true;
    add(row);

    row = {};
    row.name = "moved by 10ᵏ, coordinates representable: pixels with another bit";
    row.ks = ks_from(0, 14);
    row.scene = [](int k) { return moved(base(0), Vec3d(power10(k))); };
    row.same_as = base;
    row.bits = true;
    row.allowed = none_wrong(0, 12);
    row.asked = "0, k ≤ 12";
    row.tachyon = true;
    add(row);

    row.name = "moved by 2ᵏ: pixels with another bit";
    row.ks = ks_from(0, 40, 4);
    row.scene = [](int k) { return moved(base(0), Vec3d(std::ldexp(1.0, k))); };
    row.allowed = none_wrong(0, 40);
    row.asked = "0, k ≤ 40";
    add(row);

    row.name = "moved by 10ᵏ, any coordinates";
    row.ks = ks_from(0, 14);
    row.scene = [](int k) { return moved(thirds(0), Vec3d(power10(k))); };
    row.same_as = thirds;
    row.bits = false;
    row.allowed = [](int k) {
        return k <= 9 ? std::optional(0) : k <= 12 ? std::optional(12) : std::nullopt;
    };
    row.asked = "0, k ≤ 9; 12, k ≤ 12";
    row.plotted = true;
    add(row);

    for (const bool oblique : {false, true}) {
        const Vec3d towards =
            oblique ? normalize(Vec3d(0.3, 0.45, 0.8)) : normalize(Vec3d(0.05, 0.55, 0.8));
        row = {};
        row.name = std::string("camera at 10ᵏ, angle shrunk, against parallel rays") +
                   (oblique ? ", another view" : "");
        row.ks = ks_from(6, 20);
        row.scene = [=](int k) { return seen_along(towards, k); };
        row.same_as = [=](int) { return seen_along(towards, std::nullopt); };
        row.allowed = none_wrong(6, 20);  // more than required
        row.asked = "0, k ≤ 11; 1 at 12; 245 at 13";
        row.tachyon = true;
        row.plotted = !oblique;
        add(row);
    }

    row = {};
    row.name = "ground a ball of radius 10ᵏ, against a plane";
    row.ks = ks_from(6, 15);
    row.scene = [](int k) { return on_ground(Sphere{{0, -power10(k), 0}, power10(k)}); };
    row.same_as = [](int) { return on_ground(Plane{{0, 1, 0}, 0}); };
    row.allowed = [](int k) { return k < 7 ? std::nullopt : std::optional(k <= 12 ? 0 : 3); };
    row.asked = "0, k ≤ 12; 3, k ≤ 15";
    row.tachyon = row.plotted = true;
    add(row);

    row = {};
    row.name = "the same ball alone";
    row.ks = ks_from(1, 15);
    row.scene = row.exactly_as = ground_alone;
    row.allowed = none_wrong(1, 15);
    row.asked = "0, k ≤ 15";
    add(row);

    row = {};
    row.name = "x, y, z renamed y, z, x, k times";
    row.ks = {1, 2};
    row.scene = [](int k) { return axes_renamed(base(0), k); };
    row.same_as = base;
    row.allowed = none_wrong(1, 2);
    row.asked = "0";
    row.tachyon = true;
    add(row);

    row = {};
    row.name = "under a group, scaled by 10ᵏ";
    row.ks = {-90, -30, -12, -9, -6, -3, -2, 0, 2, 3, 6, 9, 12, 30, 90};
    row.scene = [](int k) { return under(base(0), stretched(power10(k), power10(k), power10(k))); };
    row.same_as = base;
    row.allowed = none_wrong(-9, 9);
    row.asked = "0, \\|k\\| ≤ 9";
    add(row);

    row = {};
    row.name = "under a group, moved by 10ᵏ";
    row.ks = ks_from(0, 12);
    row.scene = [](int k) { return under(base(0), shift(Vec3d(power10(k)))); };
    row.same_as = base;
    row.allowed = none_wrong(0, 9);
    row.asked = "0, k ≤ 9";
    add(row);

    row = {};
    row.name = "written 10⁻ᵏ as tall, under a group that stretches by 10ᵏ";
    row.ks = ks_from(-9, 9, 3);
    row.scene = stretched_back;
    row.same_as = base;
    row.allowed = none_wrong(-6, 6);
    row.asked = "0, \\|k\\| ≤ 6";
    add(row);

    row = {};
    row.name = "under k nested groups, each turned and moved";
    row.ks = {1, 5, 10, 20, 50};
    row.scene = nested_groups;
    row.same_as = base;
    row.allowed = none_wrong(1, 50);
    row.asked = "0, k ≤ 50";
    add(row);

    for (const double x : {0.0, 500000.123}) {
        row = {};
        row.name = std::string("sizes from 10⁻⁶ to 10⁷ in one scene") +
                   (x == 0 ? "" : ", at 500000.123") + " (k = 1: seen from 2·10⁻⁵ away)";
        row.ks = {0, 1};
        row.scene = row.exactly_as = [x](int k) { return many_sizes(x, k); };
        row.allowed = none_wrong(0, 1);
        row.asked = "0";
        add(row);
    }

    row = {};
    row.name = "random scenes, k the seed";
    row.ks = ks_from(1, 30);
    row.scene = row.exactly_as = [](int k) { return random_scene(static_cast<unsigned>(k)); };
    row.allowed = none_wrong(1, 30);
    row.asked = "1 in 10⁵ pixels";
    row.unordered = true;
    add(row);

    row.name = "random scenes of every shape, material, texture and light, k the seed";
    row.ks = ks_from(1, 100);
    row.scene = row.exactly_as = [](int k) { return random_anything(static_cast<unsigned>(k)); };
    row.allowed = none_wrong(1, 100);
    row.povray = false;  // absorption: docs/validation.md
    add(row);
    return rows;
}

}  // namespace lancer::extremes
