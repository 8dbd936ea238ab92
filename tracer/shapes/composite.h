// Composites as one shape among the others. scene/composite.h has their trees, and
// intersect/composite_crossings.h their crossings.
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
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

}  // namespace lancer
