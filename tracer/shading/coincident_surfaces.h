// Which hits of a contact count as surfaces, and which of these are visible.
#pragma once

#include "tracer/rays/crossing.h"
#include "tracer/shading/surface.h"

namespace lancer {

/// Whether one hit leaves a clear body and the other enters another body of the same material.
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

/// Where the ray meets the common edge of two faces of a mesh, leaves out the second face. So the
/// diagonal of a pane tints light only once.
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

/// Leaves out both hits wherever bodies of the same material are glued together (is_glued).
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

/// Leaves out the hits of an ordered contact that do not count as surfaces. All of them may go. For
/// light that passes straight on.
template <class Real>
void drop_coincident(const World<Real>& world, Contact<Real>& contact) {
    drop_second_faces(world, contact);
    drop_glued(world, contact);
}

/// The same for light that may be refracted.
///
/// \param ratio  index before the contact over index after it
template <class Real>
void drop_coincident(const World<Real>& world, Contact<Real>& contact, Real ratio) {
    if (ratio == 1)
        drop_coincident(world, contact);
    else
        drop_second_faces(world, contact);
}

template <class Real>
using Surfaces = boost::container::small_vector<Surface<Real>, 2>;

/// The visible surfaces of an ordered contact: if one is opaque, it hides all others; of several
/// opaque ones the object that the scene declares first is visible.
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
