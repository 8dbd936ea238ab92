// From a hit to a surface: its point, normals, colour and transmittance.
#pragma once

#include "tracer/intersect/contact.h"
#include "tracer/intersect/local_point.h"
#include "tracer/rays/frame.h"
#include "tracer/shading/texture_color.h"

namespace lancer {

/// A hit with all data that shading needs, in world space.
template <class Real>
struct Surface {
    SurfaceId id;
    const Primitive<Real>* primitive = nullptr;
    const Finish<Real>* finish = nullptr;
    Vec3<Real> position;  ///< the point is position + position_lo
    Vec3<Real> position_lo;
    Real error;            ///< bound on the point's distance from the true surface
    Vec3<Real> geometric;  ///< unit, outward
    Vec3<Real> normal;     ///< shading normal, unit, turned towards the viewer
    Vec3<Real> color;
    Vec3<Real> transmittance;  ///< T: the share of light that passes, per channel
    Real opacity;
    bool outermost = false;  ///< on the convex hull of the primitive
};

/// The primitive of the surface, if a straight line in this direction leaves it and cannot meet it
/// again; else none.
template <class Real>
std::uint32_t left_for_good(const Surface<Real>& s, const Vec3<Real>& direction) {
    const bool stays_out = s.primitive->convex || s.outermost;
    return stays_out && dot(s.geometric, direction) > 0 ? s.id.primitive : none;
}

/// Sets the colour, the transmittance and the opacity.
template <class Real>
void set_color(const World<Real>& world, const FaceOwner<Real>& owner,
               const SurfacePoint<Real>& local, Surface<Real>& s) {
    const Finish<Real>& f = *s.finish;
    s.color = f.color;
    Real filter = f.filter;
    Real transmission = f.transmission;
    if (f.texture != none) {
        const TextureColor<Real> texel =
            texture_color(world, f.texture, *owner.primitive, local, owner.face);
        s.color = texel.color;
        if (texel.has_alpha) {
            filter = 0;
            transmission = 1 - texel.alpha;
        }
    }
    s.transmittance = filter * s.color + Vec3<Real>(transmission);
    s.opacity = 1 - filter - transmission;
}

template <class Real>
void set_position(Surface<Real>& s, const DoubleWordVector<Real>& place, const Vec3<Real>& rest) {
    s.position = place.hi;
    s.position_lo = place.lo;
    if (rest == Vec3<Real>{}) return;
    const DoubleWordVector<Real> sum = normalized(place.hi, place.lo + rest);
    s.position = sum.hi;
    s.position_lo = sum.lo;
}

/// Whether a line that leaves the primitive there cannot meet it again.
///
/// The whole of a composite may lie in one convex leaf: what leaves that leaf leaves the whole.
/// Transparent bodies do not use this, because their list of bodies needs all crossings at an edge.
template <class Real>
bool is_outermost(const Primitive<Real>& whole, const FaceOwner<Real>& owner,
                  const SurfacePoint<Real>& point) {
    if (owner.primitive == &whole) return point.outermost;
    const bool opaque = !whole.medium && !whole.transmissive;
    return opaque && owner.around && (point.outermost || traits_of(owner.primitive->solid).convex);
}

template <class Real>
Surface<Real> make_surface(const World<Real>& world, const Ray<Real>& ray, Hit<Real> hit) {
    Surface<Real> s;
    s.id = hit.surface;
    s.primitive = &world.primitives[hit.surface.primitive];
    const FaceOwner<Real> owner = s.primitive->owner_of(hit.surface.face);
    const Primitive<Real>& primitive = *owner.primitive;
    hit.surface.face = owner.face;
    s.finish = &world.finishes[primitive.material];
    SurfacePoint<Real> local;
    if (primitive.frame == none) {
        local = local_point(world, primitive, ray, hit);
        const DoubleWordVector<Real> place = two_sum(local.anchor, local.offset);
        set_position(s, place, local.rest);
        s.error = local.error;
        s.geometric = unit(local.normal);
        s.normal = local.shading == local.normal ? s.geometric : unit(local.shading);
    } else {
        const Frame<Real>& frame = world.frames[primitive.frame];
        local = local_point(world, primitive, to_local(ray, frame), hit);
        // Both parts are mapped separately, so that a large shift does not round the small part.
        const Vec3<Real> anchor = map_vector(frame.to_world, local.anchor);
        const Vec3<Real> offset = map_vector(frame.to_world, local.offset);
        const DoubleWordVector<Real> inner = two_sum(anchor, offset);
        const DoubleWordVector<Real> place = two_sum(frame.to_world.shift, inner.hi);
        set_position(s, place, inner.lo);
        const Real size = max_component(absolute(anchor)) + max_component(absolute(offset));
        s.error = frame.norm * local.error +
                  mapping_error(frame, gamma<Real>(4) * size, place.lo + inner.lo);
        s.geometric = unit(map_transposed(frame.linear_inverse, local.normal));
        s.normal = local.shading == local.normal
                       ? s.geometric
                       : unit(map_transposed(frame.linear_inverse, local.shading));
    }
    if (owner.turned) s.geometric = -s.geometric;
    s.outermost = is_outermost(*s.primitive, owner, local);
    if (dot(s.normal, ray.dir) > 0) s.normal = -s.normal;
    set_color(world, owner, local, s);
    return s;
}

}  // namespace lancer
