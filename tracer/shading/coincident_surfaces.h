// What of a contact is a surface at all, and which of them show.
#pragma once

#include "tracer/rays/crossing.h"
#include "tracer/shading/surface.h"

namespace lancer {

/// Whether the hits are the end of one clear body and the beginning of another of the same matter.
template <class Real>
bool is_glued(const World<Real>& world, const Hit<Real>& a, const Hit<Real>& b) {
    const Primitive<Real>& first = world.primitives[a.surface.primitive];
    const Primitive<Real>& second = world.primitives[b.surface.primitive];
    if (!first.medium || !second.medium || a.surface.primitive == b.surface.primitive) return false;
    if (a.surface.entering == b.surface.entering) return false;
    const auto shows = [&](const Primitive<Real>& p, const Hit<Real>& hit) {
        return p.composite() == nullptr ||
               p.owner_of(hit.surface.face).primitive->material == p.material;
    };
    const Finish<Real>& matter = world.finishes[first.material];
    return first.transmissive && matter.texture == none &&
           matter == world.finishes[second.material] && shows(first, a) && shows(second, b);
}

/// Leaves out the second of two faces of a mesh where the ray meets their common edge, so that a
/// pane is tinted once on its diagonal too.
template <class Real>
void drop_second_faces(const World<Real>& world, Contact<Real>& contact) {
    for (std::size_t i = 0; i < contact.size(); ++i) {
        const SurfaceId first = contact[i].surface;
        const bool sheet = !world.primitives[first.primitive].body;
        const auto repeats = [&](const Hit<Real>& hit) {
            return hit.surface.primitive == first.primitive &&
                   (sheet || hit.surface.entering == first.entering);
        };
        const auto rest = contact.begin() + static_cast<std::ptrdiff_t>(i + 1);
        contact.erase(std::remove_if(rest, contact.end(), repeats), contact.end());
    }
}

/// Leaves out both sides of every place where one matter is glued to itself.
template <class Real>
void drop_glued(const World<Real>& world, Contact<Real>& contact) {
    for (std::size_t i = 0; i < contact.size();) {
        std::size_t j = i + 1;
        while (j < contact.size() && !is_glued(world, contact[i], contact[j])) ++j;
        if (j == contact.size()) {
            ++i;
            continue;
        }
        contact.erase(contact.begin() + static_cast<std::ptrdiff_t>(j));
        contact.erase(contact.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// Leaves out of an ordered contact what is no surface of its own, which may be all of it, for
/// light that passes it straight.
template <class Real>
void drop_coincident(const World<Real>& world, Contact<Real>& contact) {
    drop_second_faces(world, contact);
    drop_glued(world, contact);
}

/// The same for light that a step of the index may bend.
///
/// \param ratio  of the indices before and after
template <class Real>
void drop_coincident(const World<Real>& world, Contact<Real>& contact, Real ratio) {
    if (ratio == 1)
        drop_coincident(world, contact);
    else
        drop_second_faces(world, contact);
}

template <class Real>
using Surfaces = boost::container::small_vector<Surface<Real>, 2>;

/// The surfaces of an ordered contact that show: an opaque one hides all others.
template <class Real>
Surfaces<Real> shown(const World<Real>& world, const Contact<Real>& contact, const Ray<Real>& ray) {
    Surfaces<Real> surfaces;
    for (const Hit<Real>& hit : contact) surfaces.push_back(make_surface(world, ray, hit));
    const Surface<Real>* opaque = nullptr;
    for (const Surface<Real>& s : surfaces) {
        const bool earlier = opaque == nullptr || s.primitive->object < opaque->primitive->object;
        if (!(max_component(s.transmittance) > 0) && earlier) opaque = &s;
    }
    if (opaque != nullptr) {
        const Surface<Real> only = *opaque;
        surfaces.assign(1, only);
    }
    return surfaces;
}

}  // namespace lancer
