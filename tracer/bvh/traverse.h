// The traversal of the tree by a ray.
#pragma once

#include <bit>

#include "tracer/bvh/slabs.h"

namespace lancer {

/// Visits the leaves that the ray may meet at a parameter in [t_min, limit()], near ones first.
/// leaf(first, count) receives a range of `order`; it returns true to end the traversal. limit()
/// may decrease when a leaf is visited.
template <class Real, class Limit, class Leaf>
void traverse(const Bvh<Real>& bvh, const Ray<Real>& ray, Real t_min, Limit&& limit, Leaf&& leaf) {
    if (bvh.nodes.empty()) return;
    using Number = BoxNumber<Real>;
    const BoxRay<Real> box_ray(bvh.bounds, ray, t_min, limit());
    if (box_ray.misses) return;
    struct Waiting {
        std::uint32_t child;
        std::uint32_t count;
        Number near;
    };
    std::array<Waiting, bvh_stack_size<Real>> stack;
    std::size_t top = 0;
    Number last = box_ray.parameter(limit());
    Waiting item{0, 0, box_ray.first};
    for (;;) {
        if (item.count != 0) {
            if (leaf(item.child, item.count)) return;
            last = box_ray.parameter(limit());
        } else {
            const BvhNode<Real>& node = bvh.nodes[item.child];
            Children<Real> nearest(box_ray.first);
            Children<Real> farthest(last);
            for (std::size_t axis = 0; axis < 3; ++axis)
                cut_to_slabs(node, axis, box_ray.slabs[axis], nearest, farthest);
            unsigned met = at_most(nearest, widened_far<Real>(farthest));
            const std::array<Number, bvh_width<Real>> near = nearest.numbers();
            const auto next_met = [&] {
                const auto c = static_cast<std::size_t>(std::countr_zero(met));
                met &= met - 1;
                return Waiting{node.child[c], node.count[c], near[c]};
            };
            // NaN keeps empty slots as well; these are the last ones.
            if (met != 0 && (item = next_met()).child != none) {
                // Insertion sort into the stack, farthest first. The nearest child is visited next.
                const std::size_t base = top;
                while (met != 0) {  // NOLINT(bugprone-infinite-loop): next_met() changes it
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
        } while (item.near > last * far_factor<Number>);
    }
}

}  // namespace lancer
