// The implementation of build_bvh(). Only the files that instantiate it include it.
#pragma once

#include "tracer/bvh/split.h"

namespace lancer {
namespace bvh_detail {

/// All threads together split the parts of the upper tree, one part after the other. The subtrees
/// below are built by one thread each. The nodes get the same numbers as with a single thread.
template <class Real>
class Builder {
  public:
    using Number = BoxNumber<Real>;
    using Node = BvhNode<Real>;
    using Nodes = std::vector<Node>;

    Builder(BothSides<Number>& boxes, std::vector<std::uint32_t>& order, std::uint32_t leaf_size,
            int threads)
        : boxes_(boxes), split_(boxes), order_(order), leaf_size_(leaf_size), threads_(threads) {}

    void run(const Part<Number>& root, Nodes& nodes) {
        if (threads_ <= 1 || root.count <= smallest_subtree) {
            build(root, nodes);
            return;
        }
        subtree_size_ = std::max(smallest_subtree,
                                 root.count / (subtrees_per_thread * std::uint32_t(threads_)));
        build_top(root);
        std::vector<Nodes> below(subtrees_.size());
        for_each_task(static_cast<int>(subtrees_.size()), threads_, {}, [&](const NextTask& next) {
            for (int i = 0; next(i);)
                build(subtrees_[static_cast<std::size_t>(i)], below[static_cast<std::size_t>(i)]);
        });
        for (auto& side : boxes_) side.reset();  // frees memory for the copies that number() makes
        number(0, below, nodes);
    }

  private:
    static constexpr std::size_t width = bvh_width<Real>;
    static constexpr std::uint32_t smallest_subtree = 20000;
    static constexpr std::uint32_t subtrees_per_thread = 8;

    struct Children {
        std::array<Part<Number>, width> part;
        std::size_t count = 0;
    };
    /// Splits the largest part in two until there are enough parts.
    Children children_of(const Part<Number>& whole, int threads) {
        Children c;
        c.part[c.count++] = whole;
        while (c.count < width) {
            std::size_t largest = width;
            for (std::size_t i = 0; i < c.count; ++i) {
                if (c.part[i].count > leaf_size_ &&
                    (largest == width || c.part[i].count > c.part[largest].count))
                    largest = i;
            }
            if (largest == width) break;
            const auto [left, right] = split_(c.part[largest], threads);
            c.part[largest] = left;
            c.part[c.count++] = right;
        }
        return c;
    }

    /// A node with its boxes and its leaves. Children that are nodes get their numbers later.
    Node node_over(const Children& children) {
        Node node;
        for (std::size_t c = 0; c < width; ++c) {
            const bool exists = c < children.count;
            const Part<Number> part = exists ? children.part[c] : Part<Number>{};
            const Bounds<Real> box =
                exists ? widened(part.box.template bounds<Real>()) : Bounds<Real>{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                node.min[axis][c] = at_most_as_large(box.min[static_cast<int>(axis)]);
                node.max[axis][c] = -at_most_as_large(-box.max[static_cast<int>(axis)]);
            }
            node.child[c] = exists ? part.first : none;
            node.count[c] = exists && is_leaf(part) ? part.count : 0;
            if (exists && is_leaf(part)) {
                for (std::uint32_t i = part.first; i < part.first + part.count; ++i)
                    order_[i] = boxes_[part.side][i].item();
            }
        }
        return node;
    }
    bool is_leaf(const Part<Number>& part) const { return part.count <= leaf_size_; }

    /// Appends the node over `part` and all nodes below it; returns its index.
    std::uint32_t build(const Part<Number>& part, Nodes& nodes) {
        const Children children = children_of(part, 1);
        const auto index = static_cast<std::uint32_t>(nodes.size());
        nodes.push_back(node_over(children));
        for (std::size_t c = 0; c < children.count; ++c) {
            if (is_leaf(children.part[c])) continue;
            const std::uint32_t below = build(children.part[c], nodes);
            nodes[index].child[c] = below;
        }
        return index;
    }

    /// A node of the upper tree. Below each child is another such node, a subtree, or a leaf.
    struct Top {
        Node node;
        struct Below {
            std::uint32_t top = none;
            std::uint32_t subtree = none;
        };
        std::array<Below, width> below;
    };

    std::uint32_t build_top(const Part<Number>& part) {
        const Children children = children_of(part, threads_);
        const auto index = static_cast<std::uint32_t>(tops_.size());
        tops_.push_back({node_over(children), {}});
        for (std::size_t c = 0; c < children.count; ++c) {
            const Part<Number>& child = children.part[c];
            typename Top::Below below;
            if (child.count > subtree_size_) {
                below.top = build_top(child);
            } else if (!is_leaf(child)) {
                below.subtree = static_cast<std::uint32_t>(subtrees_.size());
                subtrees_.push_back(child);
            }
            tops_[index].below[c] = below;
        }
        return index;
    }

    std::uint32_t number(std::uint32_t top, std::vector<Nodes>& subtrees, Nodes& nodes) const {
        const auto index = static_cast<std::uint32_t>(nodes.size());
        nodes.push_back(tops_[top].node);
        for (std::size_t c = 0; c < width; ++c) {
            const typename Top::Below& below = tops_[top].below[c];
            if (below.top != none) {
                const std::uint32_t child = number(below.top, subtrees, nodes);
                nodes[index].child[c] = child;
            } else if (below.subtree != none) {
                nodes[index].child[c] = append(nodes, subtrees[below.subtree]);
            }
        }
        return index;
    }

    static std::uint32_t append(Nodes& nodes, Nodes& more) {
        const auto offset = static_cast<std::uint32_t>(nodes.size());
        for (Node& node : more) {
            for (std::size_t c = 0; c < width; ++c) {
                const bool inner = node.count[c] == 0 && node.child[c] != none;
                if (inner) node.child[c] += offset;
            }
            nodes.push_back(node);
        }
        more = {};
        return offset;
    }

    BothSides<Number>& boxes_;
    Splitter<Number> split_;
    std::vector<std::uint32_t>& order_;
    std::uint32_t leaf_size_;
    int threads_;
    std::uint32_t subtree_size_ = 0;
    std::vector<Top> tops_;
    std::vector<Part<Number>> subtrees_;
};

}  // namespace bvh_detail

template <class Real>
Bvh<Real> build_bvh(std::vector<Bounds<Real>> boxes, std::uint32_t leaf_size, int threads) {
    using namespace bvh_detail;
    using Number = BoxNumber<Real>;
    Bvh<Real> bvh;
    if (boxes.empty()) return bvh;
    const auto count = static_cast<std::uint32_t>(boxes.size());
    Part<Number> root{0, count, 0, 0, {}, {}};
    BothSides<Number> both;
    both[0] = std::make_unique_for_overwrite<MovingBox<Number>[]>(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        bvh.bounds.extend(boxes[i]);
        const MovingBox<Number> moving(boxes[i], i);
        root.box.extend(moving);
        root.centers.extend(moving.center(), moving.center());
        both[0][i] = moving;
    }
    boxes = {};
    both[1] = std::make_unique_for_overwrite<MovingBox<Number>[]>(count);
    bvh.bounds = widened(bvh.bounds);
    bvh.reach = bvh.bounds.reach();
    bvh.order.resize(count);
    bvh.nodes.reserve(count / leaf_size / 2 + 1);
    Builder<Real>(both, bvh.order, leaf_size, threads).run(root, bvh.nodes);
    return bvh;
}

}  // namespace lancer
