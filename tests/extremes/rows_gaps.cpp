#include "tests/extremes/rows.h"
#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

const Color floor_color{0.9, 0.8, 0.7};

Stage lit_floor(double height) {
    Stage s;
    s.look({0.3, 3.2, 4.1}, {0, 0, 0}, 40);
    s.lamp({2, 5, 3});
    s.scene.background = {0.1, 0.2, 0.4};
    s.add(Plane{{0, 1, 0}, height}, s.matt(floor_color));
    return s;
}

/// Near 0, where its thickness is representable.
Scene opaque(bool disc, double thick) {
    Stage s = lit_floor(-1);
    const std::uint32_t red = s.matt({0.9, 0.1, 0.1});
    if (disc)
        s.add(Cylinder{{0, 0, 0}, {0, thick, 0}, 0.75}, red);
    else
        s.add(Box{{-0.75, 0, -0.75}, {0.75, thick, 0.75}}, red);
    return s.scene;
}

Stage under_glass() {
    Stage s = lit_floor(0);
    s.add(Box{{-0.25, 0, -0.25}, {0.25, 0.5, 0.25}}, s.matt({0.2, 0.3, 0.9}));
    return s;
}

Scene glass_slab(double ior, int k) {
    Stage s = under_glass();
    s.add(Box{{-1, 1, -1}, {1, 1 + power10(-k), 1}}, s.glass(ior));
    return s.scene;
}

/// Red lies 10^-k above blue and must hide it, whichever is declared first.
Scene floating(bool box, bool red_first, int k) {
    Stage s;
    Material lit;
    lit.ambient = 1;
    lit.diffuse = 0;
    lit.color = {1, 0, 0};
    const std::uint32_t red = s.material(lit);
    lit.color = {0, 0, 1};
    const std::uint32_t blue = s.material(lit);
    s.look({0.3, 4, 2.5}, {0, 0, 0}, 20);
    const double gap = power10(-k);
    s.add(Plane{{0, 1, 0}, 0}, blue);
    if (box)
        s.add(Box{{-9, gap, -9}, {9, gap + 0.5, 9}}, red);
    else
        s.add(Triangle{{Vec3d(-30, gap, -30), Vec3d(30, gap, -30), Vec3d(0, gap, 40)}}, red);
    if (red_first) std::swap(s.scene.objects[0], s.scene.objects[1]);
    return s.scene;
}

/// A receiver seen from behind, lit through: its picture is the shadow on its other side, where an
/// occluder floats 10^-k above it.
Scene contact_shadow(const std::string& floor, int k) {
    Stage s;
    Material m;
    m.ambient = 0;
    m.diffuse = 0;
    m.diffuse_transmission = 1;
    const std::uint32_t paper = s.material(m);
    const double gap = power10(-k);
    if (floor == "plane") s.add(Plane{{0, 1, 0}, 0}, paper);
    if (floor == "box") s.add(Box{{-9, -1, -9}, {9, 0, 9}}, paper);
    if (floor == "cylinder") s.add(Cylinder{{0, -1, 0}, {0, 0, 0}, 9}, paper);
    if (floor == "mesh") s.add(cube({-9, -1, -9}, {9, 0, 9}), paper);
    if (floor == "ball") {
        s.add(Sphere{{0, -1, 0}, 1}, paper);
        s.add(Sphere{{0, -1, 0}, 1 + gap}, paper);
    } else {
        // A triangle has no thickness, so its far side cannot replace the near one.
        s.add(Triangle{{Vec3d(-3, gap, -3), Vec3d(3, gap, -3), Vec3d(0, gap, 4)}}, paper);
    }
    s.lamp({0.5, 4, 1});
    s.look({0.1, -0.75, 0.2}, {0, 0, 0.1}, 20, {0, 0, 1});
    return s.scene;
}

Stage over_ball() {
    Stage s = lit_floor(-1);
    s.add(Sphere{{0.2, -0.6, -0.4}, 0.4}, s.matt({0.9, 0.2, 0.1}));
    return s;
}

Scene glued(int count, double angle) {
    const Affine<double> map = compose(turn(1, angle), turn(0, angle / 2));
    Stage s = over_ball();
    for (int i = 0; i < count; ++i)
        s.add(Box{{-1, 0.5 * i / count, -1}, {1, 0.5 * (i + 1) / count, 1}}, s.glass(1.5), map);
    return s.scene;
}

Scene two_blocks(double gap) {
    Stage s = over_ball();
    s.add(Box{{-1, 0, -1}, {1, 0.25, 1}}, s.glass(1.5));
    s.add(Box{{-1, 0.25 + gap, -1}, {1, 0.5 + gap, 1}}, s.glass(1.5));
    return s.scene;
}

/// Two glass solids side by side on a plane, all turned; k the order of declaration.
Scene resting(const std::string& solid, double angle, int k) {
    const Affine<double> map = compose(turn(1, angle), turn(2, angle / 3));
    Stage s;
    s.look({0.3, 3.2, 4.1}, {0, 0, 0}, 40);
    s.lamp({2, 5, 3});
    s.scene.background = {0.1, 0.2, 0.4};
    const std::uint32_t glass = s.glass(1.5);
    s.add(Plane{{0, 1, 0}, 0}, s.matt(floor_color), map);
    for (const double x : {-0.75, 0.0}) {
        if (solid == "boxes") s.add(Box{{x, 0, -0.5}, {x + 0.75, 0.5, 0.5}}, glass, map);
        if (solid == "meshes") s.add(cube({x, 0, -0.5}, {x + 0.75, 0.5, 0.5}), glass, map);
        if (solid == "cylinders") s.add(Cylinder{{x, 0, 0}, {x, 0.5, 0}, 0.375}, glass, map);
    }
    static constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                         {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const std::vector<Object> objects = s.scene.objects;
    for (std::size_t i = 0; i < 3; ++i)
        s.scene.objects[i] = objects[static_cast<std::size_t>(orders[k - 1][i])];
    return s.scene;
}

}  // namespace

std::vector<Row> rows_of_gaps() {
    std::vector<Row> rows;
    Row row;
    for (const bool disc : {false, true}) {
        row = {};
        row.name =
            std::string("opaque ") + (disc ? "disc" : "slab") + " 10⁻ᵏ thick, and its shadow";
        row.ks = ks_from(4, 18);
        row.scene = [disc](int k) { return opaque(disc, power10(-k)); };
        row.exactly_as = row.scene;
        row.allowed = none_wrong(4, 16);
        row.asked = "0, k ≤ 16";
        row.plotted = disc;
        rows.push_back(row);
    }
    for (const double ior : {1.0, 1.5}) {
        row = {};
        row.name = std::string("glass slab 10⁻ᵏ thick, index ") + (ior == 1 ? "1" : "1.5");
        row.ks = ks_from(4, 16);
        row.scene = [ior](int k) { return glass_slab(ior, k); };
        row.same_as = [](int) { return under_glass().scene; };
        row.allowed = none_wrong(5, 15);
        row.asked = "0, k ≤ 15";
        row.plotted = ior != 1;
        rows.push_back(row);
    }
    for (const bool box : {true, false}) {
        row = {};
        row.name = std::string(box ? "box" : "triangle") + " 10⁻ᵏ above a plane hides it";
        row.ks = ks_from(1, 15);
        row.scene = [box](int k) { return floating(box, k % 2 == 0, k); };
        row.uniform = Color(1, 0, 0);
        row.allowed = none_wrong(1, 14);
        row.asked = "0, k ≤ 14";
        rows.push_back(row);
    }
    for (const char* floor : {"plane", "box", "cylinder", "mesh", "ball"}) {
        row = {};
        row.name = std::string("shadow on a ") + floor + " through a gap of 10⁻ᵏ";
        row.ks = ks_from(1, 15);
        row.scene = [floor](int k) { return contact_shadow(floor, k); };
        row.uniform = Color(0, 0, 0);
        row.allowed = none_wrong(1, 14);
        row.asked = "0, k ≤ 14";
        row.plotted = std::string(floor) == "plane";
        rows.push_back(row);
    }
    for (const double angle : {0.0, 37.0}) {
        row = {};
        row.name = std::string("k glass slabs glued together, against one") +
                   (angle == 0 ? "" : ", turned by 37°");
        row.ks = {2, 3, 4, 8, 16, 32};
        row.scene = [angle](int k) { return glued(k, angle); };
        row.same_as = [angle](int) { return glued(1, angle); };
        row.allowed = none_wrong(2, 32);
        row.asked = "0, k ≤ 32";
        rows.push_back(row);
    }
    row = {};
    row.name = "two glass blocks, air gap of 10⁻ᵏ";
    row.ks = ks_from(9, 15);
    row.scene = [](int k) { return two_blocks(power10(-k)); };
    row.exactly_as = row.scene;
    row.allowed = none_wrong(9, 15);
    row.asked = "0";
    rows.push_back(row);
    for (const char* solid : {"boxes", "meshes", "cylinders"}) {
        row = {};
        row.name = std::string("glass ") + solid +
                   " touching on a plane, turned by 37°; k the order of declaration";
        row.ks = ks_from(1, 6);
        row.scene = [solid](int k) { return resting(solid, 37, k); };
        row.exactly_as = [solid](int) { return resting(solid, 37, 1); };
        row.steady = true;
        row.allowed = none_wrong(1, 6);
        row.asked = "0";
        rows.push_back(row);
    }
    return rows;
}

}  // namespace lancer::extremes
