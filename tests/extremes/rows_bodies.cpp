#include <cmath>

#include "tests/extremes/rows.h"
#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

using Kind = Composite::Kind;

Stage table() {
    Stage s;
    s.look({0.3, 3.2, 4.1}, {0, 0, 0}, 40);
    s.lamp({2, 5, 3});
    s.scene.background = {0.1, 0.2, 0.4};
    s.add(Plane{{0, 1, 0}, -1}, s.matt({0.9, 0.8, 0.7}));
    return s;
}

/// A plate with a hole drilled from below, up to the height `end`; the plate's top is at 0.5.
Scene drilled(double end) {
    Stage s = table();
    const std::uint32_t red = s.matt({0.9, 0.2, 0.1});
    s.add_body(Kind::subtract,
               {{Box{{-1, 0, -1}, {1, 0.5, 1}}, red, {}},
                {Cylinder{{0, -0.5, 0}, {0, end, 0}, 0.5}, s.matt({0.2, 0.7, 0.3}), {}}},
               red);
    return s.scene;
}

Scene plate() {
    Stage s = table();
    s.add(Box{{-1, 0, -1}, {1, 0.5, 1}}, s.matt({0.9, 0.2, 0.1}));
    return s.scene;
}

/// A body minus itself, for several kinds of bodies, upright and rotated.
Scene nothing_left(int k) {
    Stage s = table();
    const Shape shapes[] = {Box{{-0.7, -0.3, -0.5}, {0.8, 0.9, 0.6}}, Sphere{{0.1, 0.2, 0.3}, 0.7},
                            Cylinder{{0, -0.5, 0.1}, {0.2, 0.7, 0}, 0.6},
                            Cone{{0, -0.5, 0}, {0.1, 0.9, 0}, 0.8, 0.1}, Torus{0.8, 0.3}};
    const Shape& shape = shapes[k % 5];
    Affine<double> map;
    if (k >= 5) map = compose(turn(1, 37), compose(turn(2, 11), stretched(1, 1.25, 0.75)));
    const std::uint32_t red = s.matt({0.9, 0.2, 0.1});
    s.add_body(Kind::subtract, {{shape, red, map}, {shape, red, map}}, red);
    return s.scene;
}

Stage over_ball() {
    Stage s = table();
    s.add(Sphere{{0.2, -0.6, -0.4}, 0.4}, s.matt({0.9, 0.2, 0.1}));
    return s;
}

/// Glass slabs, one upon the other, joined to one body.
Scene joined(int count) {
    const Affine<double> map = compose(turn(1, 37), turn(0, 18.5));
    Stage s = over_ball();
    const std::uint32_t glass = s.glass(1.5);
    if (count == 1) {
        s.add(Box{{-1, 0, -1}, {1, 0.5, 1}}, glass, map);
        return s.scene;
    }
    std::vector<Part> slabs;
    for (int i = 0; i < count; ++i)
        slabs.push_back(
            {Box{{-1, 0.5 * i / count, -1}, {1, 0.5 * (i + 1) / count, 1}}, glass, map});
    s.add_body(Kind::unite, slabs, glass);
    return s.scene;
}

/// The intersection of two balls with a depth of 10^-k, seen so that it fills the picture.
Scene lens(int k) {
    const double depth = power10(-k);
    const double half = std::sqrt(depth);
    Stage s;
    s.look({0.2, 2, 6}, {0, 0, 0}, 1);
    s.scene.cameras[0].projection = OrthographicProjection{3 * half};
    s.lamp({2, 5, 3});
    s.scene.background = {0.1, 0.2, 0.4};
    const std::uint32_t red = s.matt({0.9, 0.2, 0.1});
    s.add_body(
        Kind::intersect,
        {{Sphere{{0, 1 - depth / 2, 0}, 1}, red, {}}, {Sphere{{0, depth / 2 - 1, 0}, 1}, red, {}}},
        red);
    return s.scene;
}

/// A ring with a wall of 10^-k, cut open.
Scene hollow_ring(int k) {
    Stage s = table();
    const std::uint32_t red = s.matt({0.9, 0.2, 0.1});
    const std::uint32_t green = s.matt({0.2, 0.7, 0.3});
    s.add_body(Kind::subtract,
               {{Torus{1, 0.4}, red, {}},
                {Torus{1, 0.4 - power10(-k)}, green, {}},
                {Box{{-2, 0.1, -2}, {2, 2, 2}}, red, {}}},
               red);
    return s.scene;
}

/// A plate with a boss, a bore through both and a groove, all of whose faces coincide with others.
/// All coordinates are multiples of 1/8.
Stage machined() {
    Stage s = table();
    s.look({0.25, 3.25, 4.125}, {0, 0, 0}, 40);
    const std::uint32_t steel = s.matt({0.6, 0.6, 0.7});
    const std::uint32_t brass = s.matt({0.8, 0.6, 0.2});
    Composite made;
    made.nodes = {{Kind::subtract, {}, 0, 4}, {Kind::unite, {0, true}, 0, 2}};
    const auto leaf = [&](const Shape& shape, std::uint32_t material, std::uint32_t node) {
        Composite::Leaf part;
        part.object.shape = shape;
        part.object.material = material;
        part.place = {node, made.leaves.empty()};
        made.leaves.push_back(part);
    };
    leaf(Box{{-1, -0.5, -0.75}, {1, 0, 0.75}}, steel, 1);
    leaf(Cylinder{{0, 0, 0}, {0, 0.5, 0}, 0.5}, steel, 1);
    leaf(Cylinder{{0, -0.5, 0}, {0, 0.5, 0}, 0.25}, brass, 0);
    leaf(Box{{-1, -0.25, 0.5}, {1, 0, 0.75}}, brass, 0);
    s.scene.composites.push_back(made);
    s.add(CompositeRef{static_cast<std::uint32_t>(s.scene.composites.size() - 1)}, steel);
    return s;
}

}  // namespace

std::vector<Row> rows_of_bodies() {
    std::vector<Row> rows;
    const auto add = [&rows](const std::string& name, std::vector<int> ks,
                             const std::string& asked) -> Row& {
        Row row;
        row.name = name;
        row.ks = std::move(ks);
        row.asked = asked;
        row.allowed = none_wrong(row.ks.front(), row.ks.back());
        return rows.emplace_back(row);
    };
    Row& beyond =
        add("hole whose cutter ends 10⁻ᵏ beyond the face; from 17 on in it", ks_from(1, 18), "0");
    beyond.scene = [](int k) { return drilled(0.5 + power10(-k)); };
    beyond.same_as = [](int) { return drilled(1); };
    beyond.plotted = true;
    Row& before =
        add("cutter that ends 10⁻ᵏ before the face: a skin stays", ks_from(1, 16), "0, k ≤ 16");
    before.scene = [](int k) { return drilled(0.5 - power10(-k)); };
    before.same_as = [](int) { return plate(); };
    Row& itself = add("a body without itself; k its kind, from 5 on turned", ks_from(0, 9), "0");
    itself.scene = nothing_left;
    itself.same_as = [](int) { return table().scene; };
    itself.unordered = true;
    Row& glued = add("k glass slabs joined to one body, against one", {2, 3, 4, 8, 16, 32}, "0");
    glued.scene = joined;
    glued.same_as = [](int) { return joined(1); };
    Row& sliver = add("what two balls have in common that meet in a depth of 10⁻ᵏ", ks_from(1, 15),
                      "0, k ≤ 10");
    // The rim is thinner than the rounding errors in a band that grows with k.
    sliver.scene = sliver.exactly_as = lens;
    sliver.allowed = none_wrong(1, 10);
    Row& ring = add("ring with a wall of 10⁻ᵏ, cut open", ks_from(2, 15), "0, k ≤ 13");
    ring.scene = ring.exactly_as = hollow_ring;
    ring.allowed = none_wrong(2, 13);
    Row& size = add("a machined part with coincident faces, size times 10ᵏ",
                    {-90, -60, -30, -9, -6, -3, 0, 3, 6, 9, 30, 60, 90}, "0, \\|k\\| ≤ 90");
    size.scene = [](int k) { return scaled(machined().scene, power10(k)); };
    size.same_as = [](int) { return machined().scene; };
    Row& place =
        add("the same part moved by 2ᵏ: pixels with another bit", ks_from(0, 40, 4), "0, k ≤ 40");
    place.scene = [](int k) { return moved(machined().scene, Vec3d(std::ldexp(1, k))); };
    place.same_as = [](int) { return machined().scene; };
    place.bits = true;
    Row& axes = add("the same part, x, y, z renamed y, z, x, k times", ks_from(1, 2), "0");
    axes.scene = [](int k) { return axes_renamed(machined().scene, k); };
    axes.same_as = [](int) { return machined().scene; };
    return rows;
}

}  // namespace lancer::extremes
