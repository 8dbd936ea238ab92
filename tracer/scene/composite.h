// A solid made of solids: its leaves, and which of them must hold a point for the whole to hold it.
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

/// Where a child hangs: what it adds to its parent's sum while it holds the point.
struct CompositeLink {
    std::uint32_t parent = none;
    std::uint32_t weight = 1;
};

/// A union, intersection or difference holds a point while the sum over its children lies between
/// two numbers. The first child of a difference weighs 1, the others 2.
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
    std::uint32_t first_face = 0;  ///< its faces, as faces of the whole, begin here
    bool subtracted = false;       ///< the whole lies where this leaf does not
};

template <class Real>
struct CompositeTree {
    std::vector<CompositeNode> nodes;         ///< nodes[0] is the whole
    std::vector<CompositeLeaf<Real>> leaves;  ///< in the order of declaration
    std::vector<std::uint32_t> bounded;       ///< leaves that `bvh` is over, in its order
    std::vector<std::uint32_t> half_spaces;   ///< the other leaves
    Bvh<Real> bvh;
    Bounds<Real> bounds;  ///< in the world; infinite to where the whole is
    const std::vector<Frame<Real>>* frames = nullptr;  ///< of the world

    /// The leaf that a face of the whole belongs to.
    std::uint32_t leaf_of(std::uint32_t face) const {
        const auto after = std::upper_bound(
            leaves.begin(), leaves.end(), face,
            [](std::uint32_t f, const CompositeLeaf<Real>& leaf) { return f < leaf.first_face; });
        return static_cast<std::uint32_t>(after - leaves.begin()) - 1;
    }
};

/// Set in the number of a face that lies in a contact and does not show there: what starts at the
/// contact starts on it, too. It stands after all faces that show.
inline constexpr std::uint32_t hidden_face = 0x80000000;

}  // namespace lancer
