// The acceleration structure: a bounding volume hierarchy with several children per node.
//
// It does not influence the picture: boxes are widened, box tests are conservative (slabs.h), and
// only leaves compute hits. So the shape of the tree never changes a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "model/shapes.h"
#include "tracer/numerics/lanes.h"
#include "tracer/rays/bounds.h"

namespace lancer {

/// The number type of a node's boxes. For a tree in double it is float, rounded outwards: half the
/// memory, and twice as many boxes per instruction.
template <class Real>
using BoxNumber = std::conditional_t<std::is_same_v<Real, double>, float, Real>;

/// The number of children of a node: as many as two instructions can test.
template <class Real>
inline constexpr std::size_t bvh_width = std::is_same_v<BoxNumber<Real>, float> ? 8 : 4;

/// One number per child.
template <class Real>
using Children = Lanes<BoxNumber<Real>, bvh_width<Real>>;

/// The boxes of the children are side by side, so that one instruction can test several. Empty
/// slots contain an empty box.
template <class Real>
struct BvhNode {
    template <class T>
    using PerChild = std::array<T, bvh_width<Real>>;

    std::array<PerChild<BoxNumber<Real>>, 3> min;
    std::array<PerChild<BoxNumber<Real>>, 3> max;
    PerChild<std::uint32_t> child;  ///< a node, or the first item of a leaf; none: empty slot
    PerChild<std::uint32_t> count;  ///< number of items in the leaf; 0 for an inner node
};

template <class Real>
struct Bvh {
    std::vector<BvhNode<Real>> nodes;  ///< the first is the root; empty without items
    std::vector<std::uint32_t> order;  ///< items in leaf order
    Bounds<Real> bounds;
    Real reach = 0;  ///< the largest absolute coordinate of `bounds`
};

/// Builds a tree over items with these boxes, which must be finite, by the binned surface-area
/// heuristic. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007. The
/// tree is the same for any number of threads.
template <class Real>
Bvh<Real> build_bvh(std::vector<Bounds<Real>> boxes, std::uint32_t leaf_size, int threads);

/// After this many levels of splits, the builder always splits at the median. This bounds the
/// depth, and so the stack of a traversal: at most 64 + log2(2^32) levels, with all children but
/// one waiting on each.
inline constexpr int bvh_sah_levels = 64;
template <class Real>
inline constexpr std::size_t bvh_stack_size = bvh_width<Real>*(bvh_sah_levels + 32);

}  // namespace lancer
