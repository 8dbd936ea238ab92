// The acceleration structure: a bounding volume hierarchy with several children a node.
//
// It decides nothing about the picture: boxes are widened, their tests err towards "met" (slabs.h),
// and leaves alone compute hits. So its shape never changes a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "model/shapes.h"
#include "tracer/numerics/lanes.h"
#include "tracer/rays/bounds.h"

namespace lancer {

/// The number type of a node's boxes. Those of a tree in double are float, rounded outwards: half
/// the memory and twice as many an instruction.
template <class Real>
using BoxNumber = std::conditional_t<std::is_same_v<Real, double>, float, Real>;

/// Children of a node: what two instructions can test.
template <class Real>
inline constexpr std::size_t bvh_width = std::is_same_v<BoxNumber<Real>, float> ? 8 : 4;

/// One number of each child.
template <class Real>
using Children = Lanes<BoxNumber<Real>, bvh_width<Real>>;

/// Boxes side by side, so that one instruction can test several. Empty slots hold an empty box.
template <class Real>
struct BvhNode {
    template <class T>
    using PerChild = std::array<T, bvh_width<Real>>;

    std::array<PerChild<BoxNumber<Real>>, 3> min;
    std::array<PerChild<BoxNumber<Real>>, 3> max;
    PerChild<std::uint32_t> child;  ///< a node, or the first item of a leaf; none: empty slot
    PerChild<std::uint32_t> count;  ///< items in the leaf; 0: an inner node
};

template <class Real>
struct Bvh {
    std::vector<BvhNode<Real>> nodes;  ///< the first is the root; empty without items
    std::vector<std::uint32_t> order;  ///< items in leaf order
    Bounds<Real> bounds;
    Real reach = 0;  ///< the largest size of a coordinate of `bounds`
};

/// Builds a tree over items with these boxes (which must be finite), by binned surface-area
/// heuristic. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007. The
/// same tree for any number of threads.
template <class Real>
Bvh<Real> build_bvh(std::vector<Bounds<Real>> boxes, std::uint32_t leaf_size, int threads);

/// A level of splits after which the builder halves the items whatever that costs, so that the
/// depth, and with it the stack of a traversal, is bounded: 64 + log2(2^32) levels, all children
/// but one waiting on each.
inline constexpr int bvh_sah_levels = 64;
template <class Real>
inline constexpr std::size_t bvh_stack_size = bvh_width<Real>*(bvh_sah_levels + 32);

}  // namespace lancer
