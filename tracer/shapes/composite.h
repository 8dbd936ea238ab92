// Solids made of solids, as one shape among the others. What they are made of is in
// scene/composite.h, where a ray crosses them in intersect/composite_crossings.h.
#pragma once

#include <limits>

#include "tracer/shapes/traits.h"

namespace lancer {

template <class Real>
struct CompositeTree;

template <class Real>
struct CompositeSolid {
    const CompositeTree<Real>* tree;

    static constexpr SolidTraits traits{.convex = false, .face_by_face = false};
    /// The largest measure in its own space; infinite where none can be too small.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

}  // namespace lancer
