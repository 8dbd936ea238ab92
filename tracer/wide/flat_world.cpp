#include "tracer/wide/flat_world.h"

#include <cstddef>

namespace lancer::wide {
namespace {

// Level code reads the nodes of the trees where they lie.
static_assert(sizeof(Node) == sizeof(BvhNode<double>));
static_assert(offsetof(Node, min) == offsetof(BvhNode<double>, min));
static_assert(offsetof(Node, max) == offsetof(BvhNode<double>, max));
static_assert(offsetof(Node, child) == offsetof(BvhNode<double>, child));
static_assert(offsetof(Node, count) == offsetof(BvhNode<double>, count));
static_assert(nothing == none);

void put(const Vec3d& from, double (&to)[3]) {
    for (int i = 0; i < 3; ++i) to[i] = from[i];
}

Tree tree_of(const Bvh<double>& bvh) {
    Tree tree{};
    tree.nodes = reinterpret_cast<const Node*>(bvh.nodes.data());
    tree.node_count = bvh.nodes.size();
    put(bvh.bounds.min, tree.min);
    put(bvh.bounds.max, tree.max);
    return tree;
}

}  // namespace

FlatWorld::FlatWorld(const World<double>& world) {
    items_.reserve(world.primitives.size());
    for (const Primitive<double>& p : world.primitives) add(p);
    for (const lancer::Finish<double>& f : world.finishes) add(f, world);
    for (const LightSource<double>& light : world.lights) add(light, world);
    scene_.tree = tree_of(world.bvh);
    scene_.items = items_.data();
    scene_.bounded = world.bounded;
    scene_.item_count = static_cast<std::uint32_t>(items_.size());
    scene_.balls = balls_.data();
    scene_.planes = planes_.data();
    scene_.finishes = finishes_.data();
    scene_.lights = lights_.data();
    scene_.light_count = lights_.size();
    put(world.background, scene_.background);
}

void FlatWorld::add(const Primitive<double>& primitive) {
    Item item;
    item.material = primitive.material;
    item.convex = primitive.convex;
    item.casts_shadow = primitive.casts_shadow;
    const auto* ball = std::get_if<BallSolid<double>>(&primitive.solid);
    if (ball != nullptr && primitive.frame == none) {
        item.kind = Kind::ball;
        item.shape = static_cast<std::uint32_t>(balls_.size());
        Ball& b = balls_.emplace_back();
        put(ball->center, b.center);
        b.radius = ball->radius;
        b.transform_error = ball->transform_error;
        b.filter_error = ball->filter_error;
    } else if (const auto* half = std::get_if<HalfSpace<double>>(&primitive.solid)) {
        Plane& p = planes_.emplace_back();
        put(half->normal, p.normal);
        put(half->point, p.point);
        p.transform_error = half->transform_error;
        p.filter_error = half->filter_error;
        p.offset = half->offset;
        put(unit(half->normal), p.unit_normal);
    }
    items_.push_back(item);
}

void FlatWorld::add(const lancer::Finish<double>& finish, const World<double>& world) {
    Finish& f = finishes_.emplace_back();
    put(finish.color, f.color);
    put(finish.reflection, f.reflection);
    put(finish.ambient * world.ambient + finish.emission, f.own);
    f.diffuse = finish.diffuse;
    f.phong = finish.phong;
    f.shininess = finish.shininess;
    f.blinn = finish.blinn;
    f.inverse_roughness = finish.inverse_roughness;
    f.opacity = 1 - finish.filter - finish.transmission;
    f.plain = finish.metallic == 0 && !finish.fresnel && !finish.lit_from_behind;
    f.textured = finish.texture != none;
}

void FlatWorld::add(const LightSource<double>& light, const World<double>& world) {
    using SourceKind = LightSource<double>::Kind;
    Light& l = lights_.emplace_back();
    l.kind = Light::Kind::other;
    if (light.kind == SourceKind::directional) {
        l.kind = Light::Kind::directional;
        put(light.direction, l.place);
    } else {
        if (light.kind == SourceKind::point && !light.fades) l.kind = Light::Kind::point;
        put(light.position, l.place);
    }
    l.shadows = world.settings.shadows && light.shadows;
    l.fill = !light.shadows;
    put(light.color, l.color);
}

}  // namespace lancer::wide
