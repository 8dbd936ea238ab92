// The acceleration structure: a bounding volume hierarchy with several children a node.
//
// It decides nothing about the picture: boxes are widened, slab tests are conservative in the ray's
// number type, and leaves alone compute hits. So its shape never changes a pixel.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "model/shapes.h"
#include "tracer/numerics/lanes.h"
#include "tracer/rays/bounds.h"
#include "tracer/rays/ray.h"

namespace lancer {

/// Children of a node: what two instructions can test.
template <class Real>
inline constexpr std::size_t bvh_width = std::is_same_v<Real, float> ? 8 : 4;

/// One number of each child.
template <class Real>
using Children = Lanes<Real, bvh_width<Real>>;

/// Boxes side by side, so that one instruction can test several. Empty slots hold an empty box.
template <class Real>
struct BvhNode {
    template <class T>
    using PerChild = std::array<T, bvh_width<Real>>;

    std::array<PerChild<Real>, 3> min;
    std::array<PerChild<Real>, 3> max;
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
Bvh<Real> build_bvh(const std::vector<Bounds<Real>>& boxes, std::uint32_t leaf_size, int threads);

/// A level of splits after which the builder halves the items whatever that costs, so that the
/// depth, and with it the stack of a traversal, is bounded: 64 + log2(2^32) levels, all children
/// but one waiting on each.
inline constexpr int bvh_sah_levels = 64;
template <class Real>
inline constexpr std::size_t bvh_stack_size = bvh_width<Real>*(bvh_sah_levels + 32);

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
/// boxes that are perpendicular to `axis`. NaN (0 times infinity, a ray in a face of the box)
/// loses every comparison and keeps the box.
template <class Real>
[[gnu::always_inline]] inline void cut_to_slabs(const BvhNode<Real>& node, std::size_t axis,
                                                const SlabRay<Real>& ray, Children<Real>& near,
                                                Children<Real>& far) {
    const Children<Real> enter(ray.negative ? node.max[axis] : node.min[axis]);
    const Children<Real> leave(ray.negative ? node.min[axis] : node.max[axis]);
    const Children<Real> origin(ray.origin);
    const Children<Real> inv(ray.inv_dir);
    near = larger((enter - origin) * inv, near);
    far = smaller((leave - origin) * inv, far);
}

/// Far distances are multiplied by it, after the minimum, which it commutes with: Ize, "Robust BVH
/// Ray Traversal", JCGT 2(2) 2013, with two more roundings for the low part of the origin.
template <class Real>
Children<Real> widened_far(const Children<Real>& far) {
    return far * Children<Real>(1 + 2 * gamma<Real>(5));
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
    std::array<Waiting, bvh_stack_size<Real>> stack;
    std::size_t top = 0;
    const SlabRay<Real> x(ray, 0);
    const SlabRay<Real> y(ray, 1);
    const SlabRay<Real> z(ray, 2);
    Waiting item{0, 0, t_min};
    for (;;) {
        if (item.count != 0) {
            if (leaf(item.child, item.count)) return;
        } else {
            const BvhNode<Real>& node = bvh.nodes[item.child];
            Children<Real> nearest(t_min);
            Children<Real> farthest(limit());
            cut_to_slabs(node, 0, x, nearest, farthest);
            cut_to_slabs(node, 1, y, nearest, farthest);
            cut_to_slabs(node, 2, z, nearest, farthest);
            unsigned met = at_most(nearest, widened_far(farthest));
            const std::array<Real, bvh_width<Real>> near = nearest.numbers();
            const auto next_met = [&] {
                const auto c = static_cast<std::size_t>(std::countr_zero(met));
                met &= met - 1;
                return Waiting{node.child[c], node.count[c], near[c]};
            };
            // Numbers that are not keep empty slots, too: they are the last ones.
            if (met != 0 && (item = next_met()).child != none) {
                // Insertion sort, farthest first, straight into the stack; the nearest stays out.
                const std::size_t base = top;
                while (met != 0) {
                    Waiting other = next_met();
                    if (other.child == none) break;
                    if (other.near < item.near) std::swap(item, other);
                    std::size_t at = top++;
                    for (; at > base && stack[at - 1].near < other.near; --at)
                        stack[at] = stack[at - 1];
                    stack[at] = other;
                }
                continue;
            }
        }
        do {
            if (top == 0) return;
            item = stack[--top];
        } while (item.near > limit());
    }
}

}  // namespace lancer
