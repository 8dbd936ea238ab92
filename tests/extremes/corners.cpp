#include "tests/extremes/corners.h"

#include <cmath>

namespace lancer::extremes {
namespace {

using Kind = Composite::Kind;

/// The slab between -1 and 1 along one axis.
Box slab(int axis) {
    Box box{Vec3d(-2), Vec3d(2)};
    box.min[axis] = -1;
    box.max[axis] = 1;
    return box;
}

/// A body with a corner at (1, 1, 1) whose three faces are those of three parts.
void add_corner(Stage& s, unsigned long kind, std::uint32_t glass, const Affine<double>& map) {
    const auto part = [&](const Shape& shape) { return Part{shape, glass, map}; };
    const Box block{Vec3d(-1), Vec3d(1)};
    switch (kind) {
        case 0:  // a cube; each pair of its faces belongs to another part
            s.add_body(Kind::intersect, {part(slab(0)), part(slab(1)), part(slab(2))}, glass);
            return;
        case 1:  // a block that three others cut
            s.add_body(Kind::subtract,
                       {part(Box{Vec3d(-1), Vec3d(2)}), part(Box{{1, -2, -2}, {3, 3, 3}}),
                        part(Box{{-2, 1, -2}, {3, 3, 3}}), part(Box{{-2, -2, 1}, {3, 3, 3}})},
                       glass);
            return;
        case 2:  // a corner of a room, its walls three blocks
            s.add_body(Kind::unite,
                       {part(Box{Vec3d(-2), {1, 2, 2}}), part(Box{Vec3d(-2), {2, 1, 2}}),
                        part(Box{Vec3d(-2), {2, 2, 1}})},
                       glass);
            return;
        case 3:  // a ball, a rod and a block through one point
            s.add_body(Kind::intersect,
                       {part(Sphere{{0, 0, 0}, std::sqrt(3.0)}),
                        part(Cylinder{{0, -2, 0.5}, {0, 2, 0.5}, std::sqrt(1.25)}), part(slab(1))},
                       glass);
            return;
        case 4:  // a block with a bored and a turned hole that meet in its face
            s.add_body(Kind::subtract,
                       {part(block), part(Cylinder{{0, 0, 1}, {0, 2, 1}, 1}),
                        part(Sphere{{1, 1, -0.5}, 1.5})},
                       glass);
            return;
        default:  // a ring cut through its middle and across
            s.add_body(Kind::intersect,
                       {part(Torus{1.25, std::sqrt(1 + std::pow(std::sqrt(2.0) - 1.25, 2))}),
                        part(slab(0)), part(slab(2))},
                       glass);
            return;
    }
}

}  // namespace

CloseView::CloseView(std::mt19937& random, int side)
    : random_(random),
      map(random() % 2 == 0
              ? Affine<double>{}
              : compose(shift({3, 4, 5}), compose(turn(0, 360 * unit()), stretched(1, 2, 0.5)))) {
    stage.scene.settings.max_depth = 30;
    stage.scene.settings.threads = 0;
    stage.scene.width = stage.scene.height = side + static_cast<int>(random() % 2);
}

Scene CloseView::of(const Vec3d& from, const Vec3d& at, const Vec3d& aside) {
    const double zoom = power10(-static_cast<int>(random_() % 13));
    stage.look(map_point(map, from), map_point(map, at), degrees(2 * std::atan(0.2 * zoom)),
               normalize(aside + Vec3d(0, 2, 0)));
    return stage.scene;
}

Scene random_corner(std::mt19937& random, int side) {
    CloseView view(random, side);
    const Affine<double>& map = view.map;
    Stage& s = view.stage;
    const auto unit = [&] { return view.unit(); };
    add_corner(s, random() % 6, s.glass(random() % 4 == 0 ? 1 : 1 + unit()), map);
    const Vec3d aside(unit() - 0.5, unit() - 0.5, unit() - 0.5);
    Vec3d at(1);
    if (random() % 2 == 0) at[static_cast<int>(random() % 3)] -= 0.25 * unit();
    const Vec3d from = random() % 4 == 0 ? aside * 0.5 : at * 3.0 + aside * 4.0;
    return view.of(from, at, aside);
}

}  // namespace lancer::extremes
