// The shapes in the world, with the leaves of each composite instead of the composite.
#pragma once

#include "model/scene.h"

namespace lancer {

/// Calls visit(object) for the object or, if it is a composite, for each of its leaves.
template <class Visit>
void for_each_part(const Scene& scene, const Object& object, Visit&& visit) {
    const auto* ref = std::get_if<CompositeRef>(&object.shape);
    if (ref == nullptr) {
        visit(object);
        return;
    }
    for (const Composite::Leaf& leaf : scene.composites[ref->composite].leaves) visit(leaf.object);
}

/// The same for all objects of the scene.
template <class Visit>
void for_each_part(const Scene& scene, Visit&& visit) {
    for (const Object& object : scene.objects) for_each_part(scene, object, visit);
}

}  // namespace lancer
