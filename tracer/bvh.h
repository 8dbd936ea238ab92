// The acceleration structure: a bounding volume hierarchy with four children a node.
//
// It decides nothing about the picture: boxes are widened, slab tests are conservative in the ray's
// number type, and leaves alone compute hits. So its shape never changes a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/bounds.h"
#include "tracer/ray.h"

namespace lancer {

/// Four boxes side by side, so that one instruction can test several. Empty slots hold an empty
/// box.
template <class Real>
struct BvhNode {
    std::array<std::array<Real, 4>, 3> min;
    std::array<std::array<Real, 4>, 3> max;
    std::array<std::uint32_t, 4> child;  ///< a node, or the first item of a leaf; none: empty slot
    std::array<std::uint32_t, 4> count;  ///< items in the leaf; 0: an inner node
};

template <class Real>
struct Bvh {
    std::vector<BvhNode<Real>> nodes;  ///< the first is the root; empty without items
    std::vector<std::uint32_t> order;  ///< items in leaf order
    Bounds<Real> bounds;
};

/// Builds a tree over items with these boxes (which must be finite), by binned surface-area
/// heuristic. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007. The
/// same tree for any number of threads.
template <class Real>
Bvh<Real> build_bvh(const std::vector<Bounds<Real>>& boxes, std::uint32_t leaf_size, int threads);

/// A level of splits after which the builder halves the items whatever that costs, so that the
/// depth, and with it the stack of a traversal, is bounded: 64 + log2(2^32) levels, three children
/// waiting on each.
inline constexpr int bvh_sah_levels = 64;
inline constexpr int bvh_stack_size = 3 * (bvh_sah_levels + 32) + 4;

/// Visits the leaves that the ray may meet at a parameter in [t_min, limit()], near ones first.
/// `leaf(first, count)` gets a range of `order`; it returns true to end the traversal. `limit()`
/// may shrink.
///
/// The far distance is widened by 1 + 2 gamma(4): Ize, "Robust BVH Ray Traversal", JCGT 2(2) 2013,
/// with one more rounding for the low part of the origin. NaN (0 times infinity, a ray in a face of
/// the box) loses every comparison and keeps the box.
template <class Real, class Limit, class Leaf>
void traverse(const Bvh<Real>& bvh, const Ray<Real>& ray, Real t_min, Limit&& limit, Leaf&& leaf) {
    if (bvh.nodes.empty()) return;
    struct Waiting {
        std::uint32_t child;
        std::uint32_t count;
        Real near;
    };
    std::array<Waiting, bvh_stack_size> stack;
    int top = 0;
    stack[0] = {0, 0, t_min};
    const bool negative[3] = {std::signbit(ray.inv_dir.x), std::signbit(ray.inv_dir.y),
                              std::signbit(ray.inv_dir.z)};
    constexpr Real widen = 1 + 2 * gamma<Real>(4);
    while (top >= 0) {
        const Waiting item = stack[static_cast<std::size_t>(top--)];
        if (item.near > limit()) continue;
        if (item.count != 0) {
            if (leaf(item.child, item.count)) return;
            continue;
        }
        const BvhNode<Real>& node = bvh.nodes[item.child];
        std::array<Real, 4> near;
        std::array<Real, 4> far;
        near.fill(t_min);
        far.fill(limit());
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::array<Real, 4>& enter = negative[axis] ? node.max[axis] : node.min[axis];
            const std::array<Real, 4>& leave = negative[axis] ? node.min[axis] : node.max[axis];
            const int i = static_cast<int>(axis);
            const Real origin = ray.origin[i];
            const Real low = ray.origin_lo[i];
            const Real inv = ray.inv_dir[i];
            for (std::size_t c = 0; c < 4; ++c) {
                const Real t0 = ((enter[c] - origin) - low) * inv;
                const Real t1 = ((leave[c] - origin) - low) * inv * widen;
                near[c] = t0 > near[c] ? t0 : near[c];
                far[c] = t1 < far[c] ? t1 : far[c];
            }
        }
        // Insertion sort, farthest first, straight into the stack.
        const int base = top;
        for (std::size_t c = 0; c < 4; ++c) {
            if (!(near[c] <= far[c]) || node.child[c] == none) continue;
            int at = top++;
            while (at > base && stack[static_cast<std::size_t>(at)].near < near[c]) {
                stack[static_cast<std::size_t>(at + 1)] = stack[static_cast<std::size_t>(at)];
                --at;
            }
            stack[static_cast<std::size_t>(at + 1)] = {node.child[c], node.count[c], near[c]};
        }
    }
}

}  // namespace lancer
