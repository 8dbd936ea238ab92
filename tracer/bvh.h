// The acceleration structure: a bounding volume hierarchy with four children a node.
//
// It decides nothing about the picture: boxes are widened, slab tests are conservative in the ray's
// number type, and leaves alone compute hits. So its shape never changes a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracer/bounds.h"
#include "tracer/lanes.h"
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
    Real reach = 0;  ///< the largest size of a coordinate of `bounds`
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

/// A ray as the tests of one pair of a box's planes see it.
///
/// The start is hi + lo, the tests take hi alone. As |lo| <= u |hi|, that is within what the box is
/// `widened` by next to the plane, and far from the plane lo changes the distance by 2 u of itself.
template <class Real>
struct SlabRay {
    Real origin;
    Real inv_dir;
    bool negative;  ///< the direction's sign

    SlabRay(const Ray<Real>& ray, int axis)
        : origin(ray.origin[axis]), inv_dir(ray.inv_dir[axis]), negative(signbit(inv_dir)) {}
};

/// Cuts the parameters between `near` and `far` down to those between the planes of each of the
/// four boxes that are perpendicular to `axis`. NaN (0 times infinity, a ray in a face of the box)
/// loses every comparison and keeps the box.
template <class Real>
[[gnu::always_inline]] inline void cut_to_slabs(const BvhNode<Real>& node, std::size_t axis,
                                                const SlabRay<Real>& ray, Four<Real>& near,
                                                Four<Real>& far) {
    const Four<Real> enter(ray.negative ? node.max[axis] : node.min[axis]);
    const Four<Real> leave(ray.negative ? node.min[axis] : node.max[axis]);
    const Four<Real> origin(ray.origin);
    const Four<Real> inv(ray.inv_dir);
    near = larger((enter - origin) * inv, near);
    far = smaller((leave - origin) * inv, far);
}

/// Far distances are multiplied by it, after the minimum, which it commutes with: Ize, "Robust BVH
/// Ray Traversal", JCGT 2(2) 2013, with two more roundings for the low part of the origin.
template <class Real>
Four<Real> widened_far(const Four<Real>& far) {
    return far * Four<Real>(1 + 2 * gamma<Real>(5));
}

/// Visits the leaves that the ray may meet at a parameter in [t_min, limit()], near ones first.
/// `leaf(first, count)` gets a range of `order`; it returns true to end the traversal. `limit()`
/// may shrink.
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
    const SlabRay<Real> x(ray, 0);
    const SlabRay<Real> y(ray, 1);
    const SlabRay<Real> z(ray, 2);
    while (top >= 0) {
        const Waiting item = stack[static_cast<std::size_t>(top--)];
        if (item.near > limit()) continue;
        if (item.count != 0) {
            if (leaf(item.child, item.count)) return;
            continue;
        }
        const BvhNode<Real>& node = bvh.nodes[item.child];
        Four<Real> nearest(t_min);
        Four<Real> farthest(limit());
        cut_to_slabs(node, 0, x, nearest, farthest);
        cut_to_slabs(node, 1, y, nearest, farthest);
        cut_to_slabs(node, 2, z, nearest, farthest);
        const std::array<Real, 4> near = nearest.numbers();
        const std::array<Real, 4> far = widened_far(farthest).numbers();
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
