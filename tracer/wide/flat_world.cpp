#include "tracer/wide/flat_world.h"

#include <algorithm>
#include <cstddef>

#include "tracer/wide/flat_frustums.h"
#include "tracer/wide/flat_tori.h"
#include "tracer/wide/plain_vector.h"

namespace lancer::wide {
namespace {

// The code of the levels reads trees, leaves and arrays of vectors in place, so layouts must match.
static_assert(sizeof(Node) == sizeof(BvhNode<double>));
static_assert(offsetof(Node, min) == offsetof(BvhNode<double>, min));
static_assert(offsetof(Node, max) == offsetof(BvhNode<double>, max));
static_assert(offsetof(Node, child) == offsetof(BvhNode<double>, child));
static_assert(offsetof(Node, count) == offsetof(BvhNode<double>, count));
static_assert(sizeof(TriangleBlock) == sizeof(TriangleLeaf<double>));
static_assert(offsetof(TriangleBlock, corner) == offsetof(TriangleLeaf<double>, corner));
static_assert(offsetof(TriangleBlock, face) == offsetof(TriangleLeaf<double>, face));
static_assert(sizeof(Vec3d) == sizeof(double[3]));
static_assert(sizeof(Bounds<double>) == sizeof(double[6]));
static_assert(offsetof(Bounds<double>, max) == sizeof(Vec3d));
static_assert(sizeof(lancer::Mesh::Corners) == sizeof(std::uint32_t[3]));
static_assert(nothing == none);
// They fill lines of the cache.
static_assert(sizeof(Item) == 64 && sizeof(Mesh) == 128);

void put_rows(const std::array<Vec3d, 3>& from, double (&to)[3][3]) {
    for (std::size_t i = 0; i < 3; ++i) put(from[i], to[i]);
}

Frame frame_of(const lancer::Frame<double>& frame) {
    Frame f{};
    put_rows(frame.to_world.rows, f.to_world);
    put(frame.to_world.shift, f.shift);
    put_rows(frame.linear_inverse.rows, f.linear_inverse);
    f.norm = frame.norm;
    f.inverse_norm = frame.inverse_norm;
    f.transform_error = frame.transform_error;
    f.keeps_digits = frame.keeps_digits;
    return f;
}

/// Whether wide code can shade a glassy item. Planes and composites are of the other kinds. Where
/// scalar code computes the shape, rays go on in scalar code as well, which is faster.
bool is_clear(const Item& item, const Primitive<double>& primitive, const World<double>& world) {
    if (!primitive.medium || !world.has_media) return false;
    if (item.kind != Kind::ball && item.kind != Kind::box && item.kind != Kind::frustum &&
        item.kind != Kind::mesh)
        return false;
    const lancer::Finish<double>& finish = world.finishes[primitive.material];
    return finish.texture == none && !finish.lit_from_behind;
}

/// Whether the texture's colour depends only on the point, so that wide code can compute it.
bool is_pattern(const lancer::Pattern<double>& texture) {
    return std::holds_alternative<CheckerPattern<double>>(texture) ||
           std::holds_alternative<GradientPattern<double>>(texture);
}

}  // namespace

Tree tree_of(const Bvh<double>& bvh) {
    Tree tree{};
    tree.nodes = reinterpret_cast<const Node*>(bvh.nodes.data());
    tree.node_count = bvh.nodes.size();
    put(bvh.bounds.min, tree.min);
    put(bvh.bounds.max, tree.max);
    return tree;
}

FlatWorld::FlatWorld(const World<double>& world) {
    items_.reserve(world.primitives.size());
    finish_of_composites_ = static_cast<std::uint32_t>(world.finishes.size());
    frames_.reserve(world.frames.size());
    for (const lancer::Frame<double>& f : world.frames) frames_.push_back(frame_of(f));
    mesh_shapes_.reserve(2 * world.meshes.size());  // smooth and not
    add_patterns(world);
    for (const Primitive<double>& p : world.primitives) add(p, world);
    for (const lancer::Finish<double>& f : world.finishes) add(f, world);
    finishes_.emplace_back();  // finish_of_composites_: not plain
    for (const LightSource<double>& light : world.lights) add(light, world);
    scene_.has_smooth_media = world.has_smooth_media;
    for (const Item& item : items_)
        scene_.has_clear_meshes |= item.kind == Kind::mesh && item.clear;
    for (const Finish& finish : finishes_) scene_.has_absorption |= finish.absorbs;
    scene_.has_glassy = world.has_media || world.has_transmission;
    scene_.tree = tree_of(world.bvh);
    scene_.items = items_.data();
    scene_.bounded = world.bounded;
    scene_.item_count = static_cast<std::uint32_t>(items_.size());
    scene_.planes = planes_.data();
    scene_.meshes = meshes_.data();
    // All bounded items are meshes here, so the meshes have the numbers of their items.
    const std::size_t most_in_cache = 1024;
    if (meshes_.size() == world.bounded && world.bounded > most_in_cache)
        scene_.meshes_of_items = meshes_.data();
    scene_.frames = frames_.data();
    scene_.frustums = frustums_.data();
    scene_.tori = tori_.data();
    scene_.patches = patches_.data();
    scene_.has_patches = !patches_.empty();
    scene_.finishes = finishes_.data();
    scene_.texture_of = textures_.empty() ? nullptr : texture_of_.data();
    scene_.textures = textures_.data();
    scene_.patterns = patterns_.data();
    if (world.has_media) {
        scene_.medium_slots = medium_slots_.data();
        scene_.medium_bounds = reinterpret_cast<const double(*)[6]>(world.medium_bounds.data());
    }
    scene_.lights = lights_.data();
    scene_.light_count = lights_.size();
    put(world.background + Vec3d(0), scene_.background);
    scene_.has_sky = world.sky.has_value();
}

void FlatWorld::add(const Primitive<double>& primitive, const World<double>& world) {
    Item item;
    if (primitive.frame == none) item = add_in_world(primitive.solid);
    if (const auto* mesh = std::get_if<MeshInstance<double>>(&primitive.solid)) {
        item.kind = Kind::mesh;
        item.shape.index = static_cast<std::uint32_t>(meshes_.size());
        add(*mesh, primitive.frame);
    }
    if (const auto* torus = std::get_if<TorusSolid<double>>(&primitive.solid)) {
        item.kind = Kind::torus;
        item.shape.index = static_cast<std::uint32_t>(tori_.size());
        tori_.push_back(flat_torus(*torus, primitive.frame, world.frames.data()));
    }
    if (std::holds_alternative<BicubicSolid<double>>(primitive.solid)) {
        item.kind = Kind::patch;
        item.shape.index = static_cast<std::uint32_t>(patches_.size());
        patches_.push_back({frame_of_patch(primitive.frame)});
    }
    // A composite shows the materials of its leaves, so the exact methods shade it.
    item.material = primitive.composite() == nullptr ? primitive.material : finish_of_composites_;
    item.convex = primitive.convex;
    item.body = primitive.body;
    item.casts_shadow = primitive.casts_shadow;
    item.glassy = primitive.transmissive || (primitive.medium && world.has_media);
    item.clear = is_clear(item, primitive, world);
    if (item.kind == Kind::mesh) {
        meshes_.back().casts_shadow = item.casts_shadow;
        meshes_.back().glassy = item.glassy;
        meshes_.back().clear = item.clear;
    }
    if (world.has_media) medium_slots_.push_back(primitive.medium_slot);
    items_.push_back(item);
    if (world.has_textures) texture_of_.push_back(add_texture(primitive, world));
}

/// Patches of one object stand in frames of their own that are mostly alike; a ray is then taken
/// into the first of them.
std::uint32_t FlatWorld::frame_of_patch(std::uint32_t frame) {
    if (frame == none) return frame;
    const Frame& f = frames_[frame];
    std::array<double, 12> map;
    std::copy_n(&f.to_world[0][0], 9, map.begin());
    std::copy_n(f.shift, 3, map.begin() + 9);
    const auto [first, is_new] = frames_of_patches_.try_emplace(map, frame);
    // What follows from the map is alike, too; how far rounding moved the object may not be.
    return frames_[first->second].transform_error == f.transform_error ? first->second : frame;
}

void FlatWorld::add_patterns(const World<double>& world) {
    std::size_t stops = 0;
    for (const auto& texture : world.textures) {
        if (const auto* gradient = std::get_if<GradientPattern<double>>(&texture))
            stops += gradient->stops.size();
    }
    stops_.reserve(stops);  // pointers to the stops must stay valid
    for (const auto& texture : world.textures) {
        Pattern& p = patterns_.emplace_back();
        if (const auto* checker = std::get_if<CheckerPattern<double>>(&texture)) {
            p.kind = Pattern::Kind::checker;
            put(checker->even, p.even);
            put(checker->odd, p.odd);
        } else if (const auto* gradient = std::get_if<GradientPattern<double>>(&texture)) {
            p.kind = Pattern::Kind::gradient;
            put(gradient->axis, p.axis);
            p.stops = stops_.data() + stops_.size();
            p.stop_count = static_cast<std::uint32_t>(gradient->stops.size());
            for (const auto& from : gradient->stops) {
                Stop& stop = stops_.emplace_back();
                stop.at = from.at;
                put(from.color, stop.color);
            }
        }
    }
}

/// \return `nothing` if wide code cannot compute its colours
std::uint32_t FlatWorld::add_texture(const Primitive<double>& primitive,
                                     const World<double>& world) {
    if (primitive.composite() != nullptr) return nothing;
    const std::uint32_t pattern = world.finishes[primitive.material].texture;
    if (pattern == none || !is_pattern(world.textures[pattern])) return nothing;
    const Placement<double>& placement =
        world.texture_bindings[primitive.texture_binding].placement;
    Texture& t = textures_.emplace_back();
    put_rows(placement.map.rows, t.rows);
    put(placement.map.shift, t.shift);
    put(placement.bound, t.bound);
    put(placement.from, t.from);
    t.pattern = pattern;
    return static_cast<std::uint32_t>(textures_.size() - 1);
}

Item FlatWorld::add_in_world(const Solid<double>& solid) {
    Item item;
    if (const auto* ball = std::get_if<BallSolid<double>>(&solid)) {
        item.kind = Kind::ball;
        Ball& b = item.ball = {};
        put(ball->center, b.center);
        b.radius = ball->radius;
        b.transform_error = ball->transform_error;
        b.filter_error = ball->filter_error;
    } else if (const auto* box = std::get_if<BoxSolid<double>>(&solid)) {
        item.kind = Kind::box;
        Box& b = item.box = {};
        put(box->min, b.min);
        put(box->max, b.max);
        b.transform_error = box->transform_error;
    } else if (const auto* frustum = std::get_if<FrustumSolid<double>>(&solid)) {
        item.kind = Kind::frustum;
        item.shape.index = static_cast<std::uint32_t>(frustums_.size());
        item.shape.around = ball_around(*frustum);
        frustums_.push_back(flat_frustum(*frustum));
    } else if (const auto* half = std::get_if<HalfSpace<double>>(&solid)) {
        Plane& p = planes_.emplace_back();
        put(half->normal, p.normal);
        put(half->point, p.point);
        p.transform_error = half->transform_error;
        p.filter_error = half->filter_error;
        p.offset = half->offset;
        put(unit(half->normal), p.unit_normal);
    }
    return item;
}

void FlatWorld::add(const MeshInstance<double>& instance, std::uint32_t frame) {
    Mesh& m = meshes_.emplace_back();
    m.shape = shape_of(instance);
    m.frame = frame;
    if (frame == nothing) return;
    const Frame& f = frames_[frame];
    for (int i = 0; i < 3; ++i) {
        m.shift[i] = f.shift[i];
        m.inverse_x[i] = f.linear_inverse[i][0];
        m.inverse_y[i] = f.linear_inverse[i][1];
        m.inverse_z[i] = f.linear_inverse[i][2];
    }
    m.inverse_norm = f.inverse_norm;
    m.transform_error = f.transform_error;
    m.keeps_digits = f.keeps_digits;
}

const MeshShape* FlatWorld::shape_of(const MeshInstance<double>& instance) {
    const TriangleMesh<double>& mesh = *instance.mesh;
    const MeshShape*& shape = shapes_of_meshes_[{&mesh, instance.smooth}];
    if (shape != nullptr) return shape;
    MeshShape& m = mesh_shapes_.emplace_back();
    shape = &m;
    m.tree = tree_of(mesh.bvh);
    m.leaves = reinterpret_cast<const TriangleBlock*>(mesh.leaves.data());
    m.reach = mesh.bvh.reach;
    m.inward = mesh.inward.empty() ? nullptr : mesh.inward.data();
    m.vertices = reinterpret_cast<const double(*)[3]>(mesh.vertices.data());
    m.faces = reinterpret_cast<const std::uint32_t(*)[3]>(mesh.source->faces.data());
    if (instance.smooth && !mesh.normals.empty()) {
        m.normals = reinterpret_cast<const double(*)[3]>(mesh.normals.data());
        m.normal_faces = reinterpret_cast<const std::uint32_t(*)[3]>(mesh.normal_faces->data());
    }
    return shape;
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
    f.metallic = finish.metallic;
    put(finish.filter * finish.color + Vec3d(finish.transmission), f.transmittance);
    f.ior = finish.ior;
    f.fresnel = finish.fresnel ? 1 : 0;
    put(finish.absorption, f.absorption);
    f.absorbs = finish.absorbs;
    f.plain = !finish.lit_from_behind;
    f.textured = finish.texture != none;
}

void FlatWorld::add(const LightSource<double>& light, const World<double>& world) {
    using SourceKind = LightSource<double>::Kind;
    Light& l = lights_.emplace_back();
    switch (light.kind) {
        case SourceKind::point:
            l.kind = Light::Kind::point;
            put(light.position, l.place);
            break;
        case SourceKind::directional:
            l.kind = Light::Kind::directional;
            put(light.direction, l.place);
            break;
        case SourceKind::spot:
            l.kind = Light::Kind::spot;
            put(light.position, l.place);
    }
    l.fades = light.fades;
    l.fade_distance = light.fade_distance;
    l.fade_power = light.fade_power;
    put(light.direction, l.axis);
    l.cos_radius = light.cos_radius;
    l.cos_falloff = light.cos_falloff;
    l.tightness = light.tightness;
    l.shadows = world.settings.shadows && light.shadows;
    l.fill = !light.shadows;
    put(light.color, l.color);
}

}  // namespace lancer::wide
