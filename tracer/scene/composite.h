// A composite: its leaves, and which of them must contain a point so that the whole contains it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/scene.h"
#include "tracer/bvh/bvh.h"
#include "tracer/rays/frame.h"

namespace lancer {

template <class Real>
struct Primitive;

/// A child's place in the tree: its parent, and the weight that it adds to the parent's sum while
/// it contains the point.
struct CompositeLink {
    std::uint32_t parent = none;
    std::uint32_t weight = 1;
};

/// A union, intersection or difference. It contains a point if the sum of the weights of the
/// children that contain the point is in [low, high]. The first child of a difference has weight 1,
/// the others have weight 2.
struct CompositeNode {
    CompositeLink link;
    std::uint32_t low = 1;
    std::uint32_t high = std::numeric_limits<std::uint32_t>::max();

    bool holds(std::uint32_t sum) const { return sum >= low && sum <= high; }
};

template <class Real>
struct CompositeLeaf {
    Primitive<Real> primitive;
    CompositeLink link;
    std::uint32_t first_face = 0;  ///< number of its first face among the faces of the whole
    bool subtracted = false;  ///< the leaf is taken away: its outside is the inside of the whole
    bool around = false;      ///< the whole lies in the leaf
};

template <class Real>
struct CompositeTree {
    std::vector<CompositeNode> nodes;         ///< nodes[0] is the whole
    std::vector<CompositeLeaf<Real>> leaves;  ///< in the order of declaration
    std::vector<std::uint32_t> bounded;       ///< the leaves in `bvh`, in its order
    std::vector<std::uint32_t> half_spaces;   ///< the other leaves
    Bvh<Real> bvh;
    Bounds<Real> bounds;  ///< in the world; infinite where the whole may be unbounded
    const std::vector<Frame<Real>>* frames = nullptr;  ///< of the world

    /// The leaf to which a face of the whole belongs.
    std::uint32_t leaf_of(std::uint32_t face) const {
        const auto after = std::upper_bound(
            leaves.begin(), leaves.end(), face,
            [](std::uint32_t f, const CompositeLeaf<Real>& leaf) { return f < leaf.first_face; });
        return static_cast<std::uint32_t>(after - leaves.begin()) - 1;
    }
};

/// This bit is set in the number of a face that belongs to a contact but does not show there. A ray
/// that starts at the contact starts on such a face as well. Hidden faces sort after all others.
inline constexpr std::uint32_t hidden_face = 0x80000000;

}  // namespace lancer
