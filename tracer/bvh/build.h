// The builder's body; included by the files that instantiate build_bvh.
#pragma once

#include <algorithm>
#include <future>
#include <numeric>

#include "tracer/bvh/bvh.h"

namespace lancer {
namespace bvh_detail {

constexpr std::size_t bins = 16;
constexpr std::size_t parallel_items = 20000;  ///< smaller trees are built by one thread

struct Range {
    std::uint32_t first;
    std::uint32_t count;
    int depth;
};

template <class Real>
struct Builder {
    const std::vector<Bounds<Real>>& boxes;
    std::vector<std::uint32_t>& order;
    std::uint32_t leaf_size;

    /// Twice the centre: the factor changes no order.
    Vec3<Real> center(std::uint32_t item) const { return boxes[item].min + boxes[item].max; }

    Bounds<Real> bounds(const Range& r) const {
        Bounds<Real> b;
        for (std::uint32_t i = r.first; i < r.first + r.count; ++i) b.extend(boxes[order[i]]);
        return b;
    }

    /// Splits `r` where the heuristic says, or in the middle. `r.count` >= 2.
    std::pair<Range, Range> split(const Range& r) const {
        Bounds<Real> centers;
        for (std::uint32_t i = r.first; i < r.first + r.count; ++i)
            centers.extend(center(order[i]));
        const Vec3<Real> extent = centers.max - centers.min;
        std::uint32_t left = 0;
        if (r.depth < bvh_sah_levels && max_component(extent) > 0)
            left = sah_partition(r, centers, extent);
        if (left == 0 || left == r.count) {
            left = r.count / 2;
            int axis = extent.x > extent.y ? 0 : 1;
            if (extent.z > extent[axis]) axis = 2;
            const auto begin = order.begin() + r.first;
            std::nth_element(begin, begin + left, begin + r.count,
                             [&](std::uint32_t a, std::uint32_t b) {
                                 const Real ca = center(a)[axis];
                                 const Real cb = center(b)[axis];
                                 return ca != cb ? ca < cb : a < b;
                             });
        }
        return {{r.first, left, r.depth + 1}, {r.first + left, r.count - left, r.depth + 1}};
    }

    /// Items left of the best of 3 x 15 planes; 0 when no plane separates any.
    std::uint32_t sah_partition(const Range& r, const Bounds<Real>& centers,
                                const Vec3<Real>& extent) const {
        struct Bin {
            Bounds<Real> box;
            std::uint32_t count = 0;
        };
        Real best_cost = std::numeric_limits<Real>::infinity();
        int best_axis = -1;
        std::size_t best_bin = 0;
        const auto bin_of = [&](std::uint32_t item, int axis) {
            const Real share = (center(item)[axis] - centers.min[axis]) / extent[axis];
            const auto bin = static_cast<std::size_t>(share * static_cast<Real>(bins));
            return bin < bins ? bin : bins - 1;
        };
        for (int axis = 0; axis < 3; ++axis) {
            if (!(extent[axis] > 0)) continue;
            std::array<Bin, bins> bin{};
            for (std::uint32_t i = r.first; i < r.first + r.count; ++i) {
                Bin& b = bin[bin_of(order[i], axis)];
                b.box.extend(boxes[order[i]]);
                ++b.count;
            }
            std::array<Real, bins> right_cost{};
            Bounds<Real> box;
            std::uint32_t count = 0;
            for (std::size_t i = bins - 1; i > 0; --i) {
                box.extend(bin[i].box);
                count += bin[i].count;
                right_cost[i] = count == 0 ? Real(0) : half_area(box) * static_cast<Real>(count);
            }
            box = {};
            count = 0;
            for (std::size_t i = 0; i + 1 < bins; ++i) {
                box.extend(bin[i].box);
                count += bin[i].count;
                if (count == 0 || count == r.count) continue;
                const Real cost = half_area(box) * static_cast<Real>(count) + right_cost[i + 1];
                if (cost < best_cost) {
                    best_cost = cost;
                    best_axis = axis;
                    best_bin = i;
                }
            }
        }
        if (best_axis < 0) return 0;
        const auto begin = order.begin() + r.first;
        const auto middle = std::stable_partition(begin, begin + r.count, [&](std::uint32_t item) {
            return bin_of(item, best_axis) <= best_bin;
        });
        return static_cast<std::uint32_t>(middle - begin);
    }

    static constexpr std::size_t width = bvh_width<Real>;

    /// The largest number of the boxes' type that is not above x.
    static BoxNumber<Real> at_most_as_large(Real x) {
        using Number = BoxNumber<Real>;
        [[maybe_unused]] constexpr Number infinity = std::numeric_limits<Number>::infinity();
        const auto rounded = static_cast<Number>(x);
        if constexpr (std::is_same_v<Number, Real>)
            return rounded;
        else
            return static_cast<Real>(rounded) > x ? std::nextafter(rounded, -infinity) : rounded;
    }

    /// Appends the node over `r` and all below it; returns its index.
    std::uint32_t build(const Range& r, std::vector<BvhNode<Real>>& nodes, int threads) const {
        // Two-way splits of the largest parts until there are enough.
        std::array<Range, width> part{r};
        std::size_t parts = 1;
        while (parts < width) {
            std::size_t largest = width;
            for (std::size_t i = 0; i < parts; ++i) {
                if (part[i].count > leaf_size &&
                    (largest == width || part[i].count > part[largest].count))
                    largest = i;
            }
            if (largest == width) break;
            const auto [left, right] = split(part[largest]);
            part[largest] = left;
            part[parts++] = right;
        }
        const auto index = static_cast<std::uint32_t>(nodes.size());
        nodes.emplace_back();
        std::array<std::future<std::vector<BvhNode<Real>>>, width> elsewhere;
        if (threads > 1 && r.count > parallel_items) {
            for (std::size_t c = 0; c < parts; ++c) {
                if (part[c].count <= leaf_size) continue;
                elsewhere[c] = std::async(std::launch::async, [this, range = part[c]] {
                    std::vector<BvhNode<Real>> below;
                    build(range, below, 1);
                    return below;
                });
            }
        }
        for (std::size_t c = 0; c < width; ++c) {
            const Bounds<Real> box = c < parts ? widened(bounds(part[c])) : Bounds<Real>{};
            std::uint32_t child = c < parts ? part[c].first : none;
            std::uint32_t count = c < parts ? part[c].count : 0;
            if (count > leaf_size) {
                count = 0;
                if (elsewhere[c].valid()) {
                    child = append(nodes, elsewhere[c].get());
                } else {
                    child = build(part[c], nodes, 1);
                }
            }
            BvhNode<Real>& node = nodes[index];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                node.min[axis][c] = at_most_as_large(box.min[static_cast<int>(axis)]);
                node.max[axis][c] = -at_most_as_large(-box.max[static_cast<int>(axis)]);
            }
            node.child[c] = child;
            node.count[c] = count;
        }
        return index;
    }

    static std::uint32_t append(std::vector<BvhNode<Real>>& nodes,
                                std::vector<BvhNode<Real>>&& more) {
        const auto offset = static_cast<std::uint32_t>(nodes.size());
        for (BvhNode<Real>& node : more) {
            for (std::size_t c = 0; c < width; ++c) {
                const bool inner = node.count[c] == 0 && node.child[c] != none;
                if (inner) node.child[c] += offset;
            }
            nodes.push_back(node);
        }
        return offset;
    }
};

}  // namespace bvh_detail

template <class Real>
Bvh<Real> build_bvh(const std::vector<Bounds<Real>>& boxes, std::uint32_t leaf_size, int threads) {
    Bvh<Real> bvh;
    bvh.order.resize(boxes.size());
    std::iota(bvh.order.begin(), bvh.order.end(), 0u);
    if (boxes.empty()) return bvh;
    for (const Bounds<Real>& box : boxes) bvh.bounds.extend(box);
    bvh.bounds = widened(bvh.bounds);
    bvh.reach = bvh.bounds.reach();
    const bvh_detail::Builder<Real> builder{boxes, bvh.order, leaf_size};
    bvh.nodes.reserve(boxes.size() / leaf_size + 1);
    builder.build({0, static_cast<std::uint32_t>(boxes.size()), 0}, bvh.nodes, threads);
    return bvh;
}

}  // namespace lancer
