// Media: the lists of bodies that a ray is inside of.
#pragma once

#include <optional>

#include "tracer/intersect/contact.h"
#include "tracer/intersect/intersection_filter.h"
#include "tracer/intersect/starts_inside.h"
#include "tracer/scene/world.h"

namespace lancer {

/// The media around a ray.
struct Media {
    /// The bodies that contain the ray, by the geometric normals. They decide which crossings can
    /// come next, and what absorbs.
    MediaList bodies;
    /// The bodies whose refractive indices count. The two lists differ where the shading normal
    /// sends a refracted ray back to the side that it came from, or a mirrored ray through the
    /// surface: docs/shading.md, "Smooth meshes". Used only in worlds with `has_smooth_media`, else
    /// empty.
    MediaList optical;
};

template <class Real>
const MediaList& optical_of(const World<Real>& world, const Media& media) {
    return world.has_smooth_media ? media.optical : media.bodies;
}

/// The bodies around the origins of camera rays. The bodies whose bounds contain an origin are
/// found once for all rays that share it.
template <class Real>
class CameraMedia {
  public:
    /// The bodies that contain the ray's origin: largest bounding box first, then in the order of
    /// declaration.
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
    MediaList near_;  ///< bodies whose bounds contain `origin_`
};

/// Appends the body, or removes it if it is in the list.
inline void toggle(MediaList& media, std::uint32_t body) {
    const auto at = std::find(media.begin(), media.end(), body);
    if (at == media.end())
        media.push_back(body);
    else
        media.erase(at);
}

/// The media around a ray behind a contact: bodies entered are appended, then bodies left are
/// removed. `contact` has entries first.
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

/// The material of the body entered last; null in empty space.
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

/// The bodies in the list that cannot hold a point beyond the contact: a crossing was lost. Where
/// a ray meets nothing more, it can only be inside half spaces and other unbounded bodies.
///
/// A body that the contact leaves is not lost, wherever its bounds end. The surfaces of a contact
/// lie apart by up to their errors, and t is that of one of them: where a line all but touches a
/// ring, a slab that cuts the ring, and so bounds the body, ends before t by more than the
/// roundings of places.
template <class Real>
MediaList lost_bodies(const World<Real>& world, const MediaList& media, const Ray<Real>& ray,
                      const Contact<Real>& contact) {
    using std::abs;
    MediaList lost;
    if (media.empty()) return lost;
    if (contact.empty()) {
        std::copy_if(media.begin(), media.end(), std::back_inserter(lost),
                     [&](std::uint32_t body) { return body < world.bounded; });
        return lost;
    }
    const Real t = contact.front().t;
    const Vec3<Real> point = (ray.origin + t * ray.dir) + ray.origin_lo;
    const Vec3<Real> slack = gamma<Real>(16) * (absolute(ray.origin) + Vec3<Real>(abs(t))) +
                             Vec3<Real>(ray.origin_error);
    const auto is_left = [&](std::uint32_t body) {
        return std::any_of(contact.begin(), contact.end(), [&](const Hit<Real>& hit) {
            return hit.surface.primitive == body && !hit.surface.entering;
        });
    };
    for (const std::uint32_t body : media) {
        const Bounds<Real>& b = world.medium_bounds[world.primitives[body].medium_slot];
        if (!Bounds<Real>{b.min - slack, b.max + slack}.contains(point) && !is_left(body))
            lost.push_back(body);
    }
    return lost;
}

inline void drop(MediaList& media, const MediaList& lost) {
    const auto is_lost = [&](std::uint32_t body) { return contains(lost, body); };
    media.erase(std::remove_if(media.begin(), media.end(), is_lost), media.end());
}

}  // namespace lancer
