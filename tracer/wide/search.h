// How eight rays go through a tree: side by side where they keep together, one by one where they
// part.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// bvh_stack_size<double>
inline constexpr int stack_size = 768;

/// No more rays than this go on one by one: eight boxes by one ray cost what one box by eight does.
inline constexpr int few_rays = 2;

/// One ray of eight on its way through the nodes from `child` on: traverse() of bvh/traverse.h.
template <class Limit, class Leaf>
[[gnu::noinline]] void traverse_alone(const Tree& tree, const BoxRays& rays, int i, Mask& active,
                                      std::uint32_t child, const Limit& limit, Leaf&& leaf) {
    struct Waiting {
        std::uint32_t child, count;
        float near;
    };
    Waiting stack[stack_size];
    int top = 0;
    struct Axis {
        Floats enter_origin, leave_origin, enter_inverse, leave_inverse;
        int enter, leave;  ///< where in the node, in floats, the planes are
    } axes[3];
    for (int a = 0; a < 3; ++a) {
        const BoxRays::Slab& slab = rays.slabs[a];
        const bool minus = (negative(slab.leave_inverse) >> i & 1) != 0;
        axes[a] = {all(lane(slab.enter_origin, i)),  all(lane(slab.leave_origin, i)),
                   all(lane(slab.enter_inverse, i)), all(lane(slab.leave_inverse, i)),
                   8 * a + (minus ? 24 : 0),         8 * a + (minus ? 0 : 24)};
    }
    float last = lane(limit(), i);
    Waiting item{child, 0, 0};
    for (;;) {
        if (item.count != 0) {
            leaf(item.child, item.count, Mask(1) << i);
            if ((active >> i & 1) == 0) return;
            last = lane(limit(), i);
        } else {
            const Node& node = tree.nodes[item.child];
            const float* planes = &node.min[0][0];
            Floats near = all(0.0F);
            Floats far = all(last);
            for (const Axis& a : axes) {
                near = larger((load(planes + a.enter) - a.enter_origin) * a.enter_inverse, near);
                far = smaller((load(planes + a.leave) - a.leave_origin) * a.leave_inverse, far);
            }
            Mask met = at_most(near, far * all(far_factor));
            float nears[8];
            store(nears, near);
            const auto next_met = [&] {
                const int c = __builtin_ctz(met);
                met &= met - 1;
                return Waiting{node.child[c], node.count[c], nears[c]};
            };
            if (met != 0 && (item = next_met()).child != nothing) {
                const int base = top;
                while (met != 0) {
                    Waiting other = next_met();
                    if (other.child == nothing) break;
                    if (other.near < item.near) {
                        const Waiting nearer = other;
                        other = item;
                        item = nearer;
                    }
                    int at = top++;
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
        } while (item.near > last * far_factor);
    }
}

/// A box by eight rays: the parameters at which they may enter it, and which of them may.
struct Entry {
    Floats near;
    Mask met;
};
LANCER_INLINE Entry enter_box(const BoxRays& rays, const Node& node, int c, const Floats& last) {
    Floats near = all(0.0F);
    Floats far = last;
    for (int a = 0; a < 3; ++a) {
        const BoxRays::Slab& slab = rays.slabs[a];
        Floats enter = all(slab.minus ? node.max[a][c] : node.min[a][c]);
        Floats leave = all(slab.minus ? node.min[a][c] : node.max[a][c]);
        if (!slab.one_sign) {  // the one is the maximum, the other the minimum
            const Floats low = leave;
            leave = where_negative(slab.leave_inverse, low, enter);
            enter = where_negative(slab.leave_inverse, enter, low);
        }
        near = larger((enter - slab.enter_origin) * slab.enter_inverse, near);
        far = smaller((leave - slab.leave_origin) * slab.leave_inverse, far);
    }
    return {near, at_most(near, far * all(far_factor))};
}

/// Calls leaf(first, count, mask) for the leaves that rays of `active` may meet at a parameter in
/// [0, limit], near ones first. `leaf` may shrink `limit`, and take rays out of `active`.
template <class Leaf>
void traverse(const Tree& tree, const Rays& r, Mask& active, const Numbers& limit, Leaf&& leaf) {
    if (tree.node_count == 0) return;
    const BoxRays rays(tree, r, active, limit);
    Mask mask = active & ~rays.misses;
    if (mask == 0) return;
    struct Waiting {
        Floats near;
        std::uint32_t child, count;
        Mask mask;
        float key;
    };
    Waiting stack[stack_size];
    int top = 0;
    const auto parameters = [&] { return rays.parameters(limit); };
    Floats last = parameters();
    std::uint32_t child = 0;
    std::uint32_t count = 0;
    for (;;) {
        if (count != 0) {
            leaf(child, count, mask);
            last = parameters();
        } else if (__builtin_popcount(mask) <= few_rays) {
            for_each_lane(mask, [&](int i) {
                traverse_alone(tree, rays, i, active, child, parameters, leaf);
            });
            last = parameters();
        } else {
            const Node& node = tree.nodes[child];
            const int base = top;
            for (int c = 0; c < 8 && node.child[c] != nothing; ++c) {
                const Entry entry = enter_box(rays, node, c, last);
                const Mask met = entry.met & mask;
                if (met == 0) continue;
                const float key = lane(entry.near, __builtin_ctz(met));
                int at = top++;
                for (; at > base && stack[at - 1].key < key; --at) stack[at] = stack[at - 1];
                stack[at] = {entry.near, node.child[c], node.count[c], met, key};
            }
        }
        do {
            if (top == 0) return;
            const Waiting& item = stack[--top];
            mask = item.mask & active & at_most(item.near, last * all(far_factor));
            child = item.child;
            count = item.count;
        } while (mask == 0);
    }
}

}  // namespace lancer::wide::LANCER_LEVEL
