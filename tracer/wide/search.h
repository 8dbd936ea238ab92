// The traversal of a tree by eight rays: side by side while they stay together, one by one where
// they diverge.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// bvh_stack_size<double>
inline constexpr int stack_size = 768;

/// Up to this many rays go on one by one: eight boxes for one ray cost as much as one box for
/// eight.
inline constexpr int few_rays = 2;
/// The same among many meshes, where a single ray can prefetch the memory that it will need.
inline constexpr int few_rays_among_meshes = 4;

/// The order in which the boxes that a ray meets are opened.
enum class Order {
    nearest_first,
    /// Any order, leaves at once. For shadow rays: any blocker ends the search, and the limit does
    /// not change.
    any,
};

/// One ray, prepared for tests against eight boxes.
struct LoneSlabs {
    struct Axis {
        Floats enter_origin, leave_origin, enter_inverse, leave_inverse;
        int enter, leave;  ///< offsets of the planes in the node, in floats

        LANCER_INLINE void put(int axis, float from_enter, float from_leave, float by_enter,
                               float by_leave, bool minus) {
            enter_origin = all(from_enter);
            leave_origin = all(from_leave);
            enter_inverse = all(by_enter);
            leave_inverse = all(by_leave);
            enter = 8 * axis + (minus ? 24 : 0);
            leave = 8 * axis + (minus ? 0 : 24);
        }
    };
    Axis axes[3];
};

/// Prefetches the meshes or nodes that a ray visits next. Useful where there are so many meshes
/// that most of them are in no cache.
LANCER_INLINE void ask_for_memory(const Tree& tree, const Mesh* meshes, const Node& node,
                                  Mask met) {
    const auto ask = [](const void* from, int lines) {
        for (int i = 0; i < lines; ++i) __builtin_prefetch(static_cast<const char*>(from) + 64 * i);
    };
    for (; met != 0; met &= met - 1) {
        const int c = __builtin_ctz(met);
        if (node.child[c] == nothing) return;
        if (node.count[c] != 0)
            ask(meshes + node.child[c], sizeof(Mesh) / 64);
        else
            ask(tree.nodes + node.child[c], sizeof(Node) / 64);
    }
}

/// Traverses the nodes from `child` on with one ray: traverse() of bvh/traverse.h.
///
/// \param meshes    Scene::meshes_of_items, or null
/// \param last_now  last_now() returns the parameter beyond which boxes do not matter
/// \param leaf      leaf(first, count) returns true to end the search
template <Order order, class Last, class Leaf>
LANCER_INLINE void descend(const Tree& tree, const Mesh* meshes, const LoneSlabs& slabs,
                           std::uint32_t child, const Last& last_now, Leaf&& leaf) {
    struct Waiting {
        std::uint32_t child, count;
        float near;
    };
    Waiting stack[stack_size];
    int top = 0;
    float last = last_now();
    Waiting item{child, 0, 0};
    for (;;) {
        if (item.count != 0) {
            if (leaf(item.child, item.count)) return;
            if constexpr (order == Order::nearest_first) last = last_now();
        } else {
            const Node& node = tree.nodes[item.child];
            const float* planes = &node.min[0][0];
            Floats near = all(0.0F);
            Floats far = all(last);
            for (const LoneSlabs::Axis& a : slabs.axes) {
                near = larger((load(planes + a.enter) - a.enter_origin) * a.enter_inverse, near);
                far = smaller((load(planes + a.leave) - a.leave_origin) * a.leave_inverse, far);
            }
            Mask met = at_most(near, far * all(far_factor));
            float nears[8];
            store(nears, near);
            if (meshes != nullptr) ask_for_memory(tree, meshes, node, met);
            const auto next_met = [&] {
                const int c = __builtin_ctz(met);
                met &= met - 1;
                return Waiting{node.child[c], node.count[c], nears[c]};
            };
            if constexpr (order == Order::any) {
                for (; met != 0; met &= met - 1) {
                    const int c = __builtin_ctz(met);
                    if (node.child[c] == nothing) break;
                    if (node.count[c] == 0)
                        stack[top++] = {node.child[c], 0, 0};
                    else if (leaf(node.child[c], node.count[c]))
                        return;
                }
                met = 0;
            }
            if (met != 0 && (item = next_met()).child != nothing) {
                const int base = top;
                while (met != 0) {  // NOLINT(bugprone-infinite-loop): next_met() changes it
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
        } while (order == Order::nearest_first && item.near > last * far_factor);
    }
}

/// Traverses the nodes from `child` on with one of eight rays.
template <Order order, class Limit, class Leaf>
[[gnu::noinline]] void traverse_alone(const Tree& tree, const Mesh* meshes, const BoxRays& rays,
                                      int i, Mask& active, std::uint32_t child, const Limit& limit,
                                      Leaf&& leaf) {
    LoneSlabs slabs;
    for (int a = 0; a < 3; ++a) {
        const BoxRays::Slab& s = rays.slabs[a];
        slabs.axes[a].put(a, lane(s.enter_origin, i), lane(s.leave_origin, i),
                          lane(s.enter_inverse, i), lane(s.leave_inverse, i),
                          (negative(s.leave_inverse) >> i & 1) != 0);
    }
    descend<order>(
        tree, meshes, slabs, child, [&] { return lane(limit(), i); },
        [&](std::uint32_t first, std::uint32_t count) {
            leaf(first, count, Mask(1) << i);
            return (active >> i & 1) == 0;
        });
}

/// BoxRays for two boxes at once.
struct BoxRayPairs {
    struct Slab {
        FloatPairs enter_origin, leave_origin, enter_inverse, leave_inverse;
        bool minus, one_sign;
    } slabs[3];

    LANCER_INLINE explicit BoxRayPairs(const BoxRays& rays) {
        for (int a = 0; a < 3; ++a) {
            const BoxRays::Slab& s = rays.slabs[a];
            slabs[a] = {both(s.enter_origin),
                        both(s.leave_origin),
                        both(s.enter_inverse),
                        both(s.leave_inverse),
                        s.minus,
                        s.one_sign};
        }
    }
};

/// The test of eight rays against two boxes: the parameters at which the rays may enter, and the
/// rays that may meet the boxes.
struct Entries {
    FloatPairs near;
    Mask met;  ///< eight bits for the first box, then eight for the second
};
LANCER_INLINE Entries enter_boxes(const BoxRayPairs& rays, const Node& node, int c,
                                  const FloatPairs& last) {
    FloatPairs near = both(all(0.0F));
    FloatPairs far = last;
    for (int a = 0; a < 3; ++a) {
        const BoxRayPairs::Slab& slab = rays.slabs[a];
        FloatPairs enter = both(slab.minus ? node.max[a] : node.min[a], c);
        FloatPairs leave = both(slab.minus ? node.min[a] : node.max[a], c);
        if (!slab.one_sign) {  // enter is the maximum and leave the minimum
            const FloatPairs low = leave;
            leave = where_negative(slab.leave_inverse, low, enter);
            enter = where_negative(slab.leave_inverse, enter, low);
        }
        near = larger((enter - slab.enter_origin) * slab.enter_inverse, near);
        far = smaller((leave - slab.leave_origin) * slab.leave_inverse, far);
    }
    return {near, at_most(near, far * both(all(far_factor)))};
}

/// Calls leaf(first, count, mask) for the leaves that rays of `active` may meet at a parameter in
/// [0, limit]. `leaf` may remove rays from `active`. With Order::nearest_first it may also lower
/// `limit`.
///
/// \param meshes  Scene::meshes_of_items, or null
template <Order order, class Leaf>
void traverse(const Tree& tree, const Mesh* meshes, const Rays& r, Mask& active,
              const Numbers& limit, Leaf&& leaf) {
    if (tree.node_count == 0) return;
    const BoxRays rays(tree, r, active, limit);
    Mask mask = active & ~rays.misses;
    if (mask == 0) return;
    const BoxRayPairs pairs(rays);
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
    const int few = meshes != nullptr ? few_rays_among_meshes : few_rays;
    for (;;) {
        if (count != 0) {
            leaf(child, count, mask);
            if constexpr (order == Order::nearest_first) last = parameters();
        } else if (__builtin_popcount(mask) <= few) {
            for_each_lane(mask, [&](int i) {
                traverse_alone<order>(tree, meshes, rays, i, active, child, parameters, leaf);
            });
            if constexpr (order == Order::nearest_first) last = parameters();
        } else {
            const Node& node = tree.nodes[child];
            const int base = top;
            const auto wait = [&](int c, const Floats& near, Mask met) {
                if constexpr (order == Order::any) {
                    if (node.count[c] == 0) {
                        stack[top].child = node.child[c];
                        stack[top].count = 0;
                        stack[top++].mask = met;
                    } else if ((met &= active) != 0) {
                        leaf(node.child[c], node.count[c], met);
                    }
                    return;
                }
                const float key = lane(near, __builtin_ctz(met));
                int at = top++;
                for (; at > base && stack[at - 1].key < key; --at) stack[at] = stack[at - 1];
                stack[at] = {near, node.child[c], node.count[c], met, key};
            };
            const FloatPairs most = both(last);
            // Empty slots are the last ones, and no ray meets their boxes.
            for (int c = 0; c < 8 && node.child[c] != nothing; c += 2) {
                const Entries entries = enter_boxes(pairs, node, c, most);
                const Mask first = entries.met & mask;
                const Mask second = entries.met >> 8 & mask;
                if (first != 0) wait(c, first_of(entries.near), first);
                if (second != 0 && node.child[c + 1] != nothing)
                    wait(c + 1, second_of(entries.near), second);
            }
        }
        do {
            if (top == 0) return;
            const Waiting& item = stack[--top];
            mask = item.mask & active;
            if constexpr (order == Order::nearest_first)
                mask &= at_most(item.near, last * all(far_factor));
            child = item.child;
            count = item.count;
        } while (mask == 0);
    }
}

}  // namespace lancer::wide::LANCER_LEVEL
