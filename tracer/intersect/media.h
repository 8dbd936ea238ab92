// The bodies that a ray is inside of, from the camera on.
#pragma once

#include <optional>

#include "tracer/intersect/nearest_contact.h"
#include "tracer/rays/crossing.h"

namespace lancer {

/// What is around a ray.
struct Media {
    /// The bodies that it is inside of, by the geometric normals: which crossings can come next,
    /// and what absorbs.
    MediaList bodies;
    /// The bodies whose refractive index counts. Where the shading normal sends a refracted ray to
    /// the side that it came from, or a mirrored one through the surface, the two lists differ:
    /// docs/shading.md, "Smooth meshes". Kept only in worlds that have_smooth_media, else empty.
    MediaList optical;
};

template <class Real>
const MediaList& optical_of(const World<Real>& world, const Media& media) {
    return world.has_smooth_media ? media.optical : media.bodies;
}

/// Whether the line's start lies in the body. A start on its surface belongs to the side that the
/// ray goes to.
template <class Real>
bool starts_inside(const World<Real>& world, std::uint32_t index, const Ray<Real>& ray) {
    const Primitive<Real>& p = world.primitives[index];
    if (const auto* half = std::get_if<HalfSpace<Real>>(&p.solid)) {
        using std::abs;
        const Vec3<Real> rel = start_from(ray, half->point);
        const Real height = dot(half->normal, rel);
        const Real bound =
            ray.origin_error + gamma<Real>(4) * dot(absolute(half->normal), absolute(rel));
        if (abs(height) > bound) return height < 0;
        return dot(half->normal, ray.dir) < 0;
    }
    if (const CompositeTree<Real>* tree = p.composite()) {
        const Start<Real> here;
        const CompositeStart<Real> known{&here, index};
        return CompositeWalk<Real>(*tree, ray, known).starts_inside();
    }
    int balance = 0;  // ways out less ways in, ahead
    primitive_crossings(world, p, ray, IntersectionHints{}, whole_line<Real>(),
                        [&](const Crossing<Real>& c, Real, Real) {
                            if (c.t > c.error) balance += c.entering ? -1 : 1;
                            return false;
                        });
    return balance > 0;
}

/// The bodies around the origins of camera rays. Whose bounds hold an origin is found once for all
/// rays that share it.
template <class Real>
class CameraMedia {
  public:
    /// Largest bounding box first, then in the order of declaration.
    Media around(const World<Real>& world, const Ray<Real>& ray) {
        Media media;
        if (!world.has_media) return media;
        if (origin_ != ray.origin) look_around(world, ray.origin);
        for (const std::uint32_t body : near_) {
            if (starts_inside(world, body, ray)) media.bodies.push_back(body);
        }
        if (world.has_smooth_media) media.optical = media.bodies;
        return media;
    }

  private:
    void look_around(const World<Real>& world, const Vec3<Real>& origin) {
        near_.clear();
        for (std::size_t i = 0; i < world.mediums.size(); ++i) {
            if (world.medium_bounds[i].contains(origin)) near_.push_back(world.mediums[i]);
        }
        origin_ = origin;
    }

    std::optional<Vec3<Real>> origin_;
    MediaList near_;  ///< bodies whose bounds hold `origin_`
};

/// Appends the body, or drops it if it is there.
inline void toggle(MediaList& media, std::uint32_t body) {
    const auto at = std::find(media.begin(), media.end(), body);
    if (at == media.end())
        media.push_back(body);
    else
        media.erase(at);
}

/// What is around a ray behind a contact: its entries appended, then its exits dropped. `contact`
/// has entries first.
template <class Real>
Media crossed(const World<Real>& world, const Media& media, const Contact<Real>& contact) {
    Media after = media;
    if (!world.has_media) return after;
    for (const Hit<Real>& hit : contact) {
        const std::uint32_t body = hit.surface.primitive;
        if (!world.primitives[body].medium) continue;
        if (contains(after.bodies, body) == hit.surface.entering) continue;
        toggle(after.bodies, body);
        if (world.has_smooth_media) toggle(after.optical, body);
    }
    return after;
}

/// The matter of the last body entered; null in empty space.
template <class Real>
const Finish<Real>* medium_of(const World<Real>& world, const MediaList& media) {
    if (media.empty()) return nullptr;
    return &world.finishes[world.primitives[media.back()].material];
}

template <class Real>
Real index_of(const World<Real>& world, const Media& media) {
    const Finish<Real>* medium = medium_of(world, optical_of(world, media));
    return medium == nullptr ? Real(1) : medium->ior;
}

/// Drops the bodies that cannot hold a point beyond parameter t of the ray although they are in the
/// list: a crossing was lost. Returns how many.
template <class Real>
std::uint64_t drop_lost(const World<Real>& world, MediaList& media, const Ray<Real>& ray, Real t) {
    using std::abs;
    if (media.empty()) return {};
    const Vec3<Real> point = (ray.origin + t * ray.dir) + ray.origin_lo;
    const Vec3<Real> slack = gamma<Real>(16) * (absolute(ray.origin) + Vec3<Real>(abs(t))) +
                             Vec3<Real>(ray.origin_error);
    const auto outside = [&](std::uint32_t body) {
        const Bounds<Real>& b = world.medium_bounds[world.primitives[body].medium_slot];
        return !Bounds<Real>{b.min - slack, b.max + slack}.contains(point);
    };
    const auto end = std::remove_if(media.begin(), media.end(), outside);
    const auto lost = static_cast<std::uint64_t>(media.end() - end);
    media.erase(end, media.end());
    return lost;
}

/// A ray that meets nothing more is only inside half spaces; anything else in its list lost a
/// crossing. Returns how many did.
template <class Real>
std::uint64_t drop_bounded(const World<Real>& world, MediaList& media) {
    const auto bounded = [&](std::uint32_t body) { return body < world.bounded; };
    const auto end = std::remove_if(media.begin(), media.end(), bounded);
    const auto lost = static_cast<std::uint64_t>(media.end() - end);
    media.erase(end, media.end());
    return lost;
}

}  // namespace lancer
