// Records what the recursion does, as a ray tree.
#pragma once

#include <algorithm>

#include "tracer/intersect/media.h"
#include "tracer/rays/ray_tree.h"
#include "tracer/rays/trace_limits.h"
#include "tracer/shading/light_sample.h"
#include "tracer/shading/surface.h"

namespace lancer {

/// The recursion calls these functions while it runs. They compute nothing that it reads, so the
/// tree shows exactly the operations that make the picture. Unrecorded has the same functions, but
/// empty.
template <class Real>
class RayTreeRecorder {
  public:
    static constexpr bool wants_light = true;

    /// `world` and `tree` must outlive this object.
    RayTreeRecorder(const World<Real>& world, const TraceLimits& limits, RayTree& tree)
        : world_(&world), limits_(limits), tree_(&tree) {}

    /// A call of the recursion begins, for a camera ray. Its light has the factor 1.
    void begin_camera_ray() { begin_call(RayTree::Kind::camera, Color(1)); }

    /// A call begins, for the ray that the last surface mirrors. Its light has the product of these
    /// factors.
    void begin_mirrored(const Vec3<Real>& through, const Vec3<Real>& passed,
                        const Vec3<Real>& mirror, Real weight) {
        const Color factor = factor_ * color(through) * color(passed) * color(mirror);
        skip_mirrored(mirror, weight);
        if (is_open()) surface().mirrored = next_ray();
        begin_call(RayTree::Kind::mirrored, factor);
    }
    /// The ray that the last surface mirrors is not followed.
    void skip_mirrored(const Vec3<Real>& mirror, Real weight) {
        if (!is_open()) return;
        surface().reflectance = color(mirror);
        surface().mirror_weight = static_cast<double>(weight);
    }
    void end_call() {
        ray_ = calls_.back().ray;
        factor_ = calls_.back().factor;
        calls_.pop_back();
    }

    /// The same call continues with a ray in another direction.
    void begin_bent(bool total) {
        if (!is_open()) return;
        contact().bent = next_ray();
        add_ray(total ? RayTree::Kind::total : RayTree::Kind::refracted);
    }

    /// \param t  of the ray: what its length is counted from
    void start(const Ray<Real>& ray, Real t, const auto& bodies, Real weight, int depth) {
        if (!is_open()) return;
        RayTree::Ray& r = own();
        start_ = t;
        r.origin = place(ray.origin + t * ray.dir, ray.origin_lo);
        r.direction = color(ray.dir);
        r.inside = objects_of(bodies);
        r.weight = static_cast<double>(weight);
        r.depth = depth;
    }

    /// is_followed() said no. The colours are the product of all factors since the call began.
    void end_at_limit(const Vec3<Real>&, Real weight, int depth) {
        if (!is_open()) return;
        own().end = depth < limits_.max_depth ? RayTree::End::weight : RayTree::End::depth;
        own().end_weight = static_cast<double>(weight);
    }
    /// \param share  of the background's light that arrives at the start of the call
    void end_in_background(const Vec3<Real>& share) {
        if (!is_open()) return;
        own().end = RayTree::End::background;
        own().share = factor_ * color(share);
    }
    void end_opaque() {
        if (is_open()) own().end = RayTree::End::opaque;
    }
    void end_after_surfaces(const Vec3<Real>&) {
        if (is_open()) own().end = RayTree::End::surfaces;
    }

    /// \param hits     in the order of order_contact()
    /// \param after    bodies that contain the ray behind the contact
    /// \param through  product of the transmittances before the contact
    void meet(Real t, const Contact<Real>& hits, const auto& after, const Vec3<Real>& through) {
        if (!add_node()) return;
        RayTree::Contact& c = own().contacts.emplace_back();
        c.t = length(t - start_);
        for (const Hit<Real>& hit : hits)
            c.hits.push_back({owner(hit.surface), face(hit.surface), length(hit.t - start_),
                              length(hit.error), hit.surface.entering});
        c.inside = objects_of(after);
        c.share = factor_ * color(through);
    }
    void bend(Real ratio, bool total) {
        if (!is_open()) return;
        contact().index_ratio = static_cast<double>(ratio);
        contact().total = total;
    }

    /// A surface of the contact, before its light is computed.
    void shade(const Surface<Real>& s, const Vec3<Real>& through, const Vec3<Real>& passed) {
        if (!add_node()) return;
        RayTree::Surface& to = contact().surfaces.emplace_back();
        to.of = owner(s.id);
        to.face = face(s.id);
        to.material = static_cast<std::uint32_t>(s.finish - world_->finishes.data());
        to.point = place(s.position, s.position_lo);
        to.point_error = length(s.error);
        to.geometric = color(s.geometric);
        to.normal = color(s.normal);
        to.color = color(s.color);
        to.transmittance = color(s.transmittance);
        to.weight = factor_ * color(through) * color(passed);
    }
    /// The last surface's ambient and emitted light.
    void glow(const Vec3<Real>& sum) {
        if (is_open()) surface().glow = surface().own = color(sum);
    }

    /// \param asked  whether the material reflects or transmits light from that side
    void ask_light(std::size_t index, const LightSample<Real>& at, Real cosine, bool asked) {
        if (!add_node()) return;
        RayTree::Light& to = surface().lights.emplace_back();
        to.light = static_cast<std::uint32_t>(index);
        to.direction = color(at.direction);
        to.distance = length(at.distance);
        to.cosine = static_cast<double>(cosine);
        to.sent = color(at.color);
        to.asked = asked;
    }
    void arrive(const Vec3<Real>& share) {
        if (is_open()) light().share = color(share);
    }
    /// \param sum  the surface's light so far, including this source
    void end_light(const Vec3<Real>& sum) {
        if (!is_open()) return;
        light().added = color(sum) - surface().own;
        surface().own = color(sum);
    }

    /// The primitive blocks the way to the light.
    void block(std::uint32_t primitive) { lose(RayTree::Loss::Kind::blocked, {primitive}, 0, {}); }
    /// The surface lets this share of the light pass.
    void filter(const SurfaceId& at, Real t, const Vec3<Real>& share) {
        lose(RayTree::Loss::Kind::surface, at, t, share);
    }
    /// The innermost body lets this share pass up to t.
    void absorb(const MediaList& bodies, Real t, const Vec3<Real>& share) {
        lose(RayTree::Loss::Kind::medium, {bodies.back()}, t, share);
    }

  private:
    /// The state to which the end of a call returns.
    struct Call {
        std::uint32_t ray;
        Color factor;
    };
    /// A larger tree is of no use, and memory is limited.
    static constexpr std::size_t most_nodes = 100'000;

    bool is_open() const { return !tree_->is_cut; }
    bool add_node() {
        if (is_open()) tree_->is_cut = ++nodes_ > most_nodes;
        return is_open();
    }

    std::uint32_t next_ray() const { return static_cast<std::uint32_t>(tree_->rays.size()); }
    void add_ray(RayTree::Kind kind) {
        if (!is_open()) return;
        ++nodes_;
        ray_ = next_ray();
        tree_->rays.emplace_back().kind = kind;
    }
    void begin_call(RayTree::Kind kind, const Color& factor) {
        calls_.push_back({ray_, factor_});
        factor_ = factor;
        add_ray(kind);
    }

    RayTree::Ray& own() { return tree_->rays[ray_]; }
    RayTree::Contact& contact() { return own().contacts.back(); }
    RayTree::Surface& surface() { return contact().surfaces.back(); }
    RayTree::Light& light() { return surface().lights.back(); }

    void lose(RayTree::Loss::Kind kind, const SurfaceId& at, Real t, const Vec3<Real>& share) {
        if (is_open()) light().losses.push_back({kind, owner(at), length(t), color(share)});
    }

    static Color color(const Vec3<Real>& v) { return convert<double>(v); }
    /// A length of the world, in units of the scene.
    double length(Real t) const { return static_cast<double>(ldexp(t, -world_->scale_exponent)); }
    Vec3d place(const Vec3<Real>& p, const Vec3<Real>& lo) const {
        return {length(p.x + lo.x), length(p.y + lo.y), length(p.z + lo.z)};
    }

    std::vector<std::uint32_t> objects_of(const MediaList& bodies) const {
        std::vector<std::uint32_t> objects;
        for (const std::uint32_t body : bodies) objects.push_back(world_->primitives[body].object);
        return objects;
    }
    std::vector<std::uint32_t> objects_of(const Media& media) const {
        return objects_of(media.bodies);
    }
    static std::vector<std::uint32_t> objects_of(NoMedia) { return {}; }

    RayTree::Owner owner(const SurfaceId& at) const {
        const Primitive<Real>& p = world_->primitives[at.primitive];
        const CompositeTree<Real>* tree = p.composite();
        return {p.object, tree == nullptr ? none : tree->leaf_of(at.face & ~hidden_face)};
    }
    std::uint32_t face(const SurfaceId& at) const {
        return world_->primitives[at.primitive].owner_of(at.face).face;
    }

    const World<Real>* world_;
    TraceLimits limits_;
    RayTree* tree_;
    std::vector<Call> calls_;
    std::uint32_t ray_ = none;
    Color factor_{1, 1, 1};
    Real start_ = 0;  ///< parameter where the current ray begins
    std::size_t nodes_ = 0;
};

}  // namespace lancer
