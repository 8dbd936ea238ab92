// Which leaves of a composite contain a point, and whether the whole contains it, along a ray.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/scene/composite.h"

namespace lancer {

/// The state of one composite along one line, from its far end back to the start. The cost is
/// proportional to the number of changes, not to the number of leaves: the memory belongs to the
/// thread and is not cleared; an entry counts only if its time stamp is that of the present line.
template <class Real>
class CompositeState {
  public:
    explicit CompositeState(const CompositeTree<Real>& tree) : tree_(tree), memory_(memory()) {
        if (memory_.leaves.size() < tree.leaves.size()) memory_.leaves.resize(tree.leaves.size());
        if (memory_.nodes.size() < tree.nodes.size()) memory_.nodes.resize(tree.nodes.size());
        line_ = ++memory_.clock;
        step_ = line_;
    }

    /// Whether the whole contains the point.
    bool holds() const { return node_holds(0); }
    /// How many times the leaf contains it; a mesh may overlap itself.
    std::uint32_t depth(std::uint32_t leaf) const {
        const LeafEntry& entry = memory_.leaves[leaf];
        return entry.line == line_ ? entry.depth : 0;
    }

    /// Begins a step, to which changed_the_whole() refers.
    void begin_step() { step_ = ++memory_.clock; }

    void set_depth(std::uint32_t leaf, std::uint32_t depth) {
        const bool before = this->depth(leaf) > 0;
        memory_.leaves[leaf] = {line_, depth};
        if (before != (depth > 0)) change(tree_.leaves[leaf].link, depth > 0);
    }

    /// Whether, in this step, every node above the leaf changed. The leaf itself must have changed.
    /// If the whole changed, this holds for at least one of the leaves that changed.
    bool changed_the_whole(std::uint32_t leaf) const {
        std::uint32_t node = tree_.leaves[leaf].link.parent;
        for (; node != none; node = tree_.nodes[node].link.parent) {
            const NodeEntry& entry = memory_.nodes[node];
            if (entry.line != line_ || entry.step != step_ || entry.held == node_holds(node))
                return false;
        }
        return true;
    }

  private:
    struct LeafEntry {
        std::uint64_t line = 0;
        std::uint32_t depth = 0;
    };
    struct NodeEntry {
        std::uint64_t line = 0;
        std::uint64_t step = 0;
        std::uint32_t sum = 0;
        bool held = false;  ///< before the step
    };
    struct Memory {
        std::vector<LeafEntry> leaves;
        std::vector<NodeEntry> nodes;
        std::uint64_t clock = 0;
    };
    static Memory& memory() {
        thread_local Memory all;
        return all;
    }

    std::uint32_t sum(std::uint32_t node) const {
        const NodeEntry& entry = memory_.nodes[node];
        return entry.line == line_ ? entry.sum : 0;
    }
    bool node_holds(std::uint32_t node) const { return tree_.nodes[node].holds(sum(node)); }

    /// A child contains the point from now on, or no longer.
    void change(CompositeLink link, bool holds) {
        while (link.parent != none) {
            const CompositeNode& node = tree_.nodes[link.parent];
            NodeEntry& entry = memory_.nodes[link.parent];
            if (entry.line != line_) entry = {line_, 0, 0, false};
            const bool before = node.holds(entry.sum);
            if (entry.step != step_) {
                entry.step = step_;
                entry.held = before;
            }
            entry.sum += holds ? link.weight : 0 - link.weight;
            if (node.holds(entry.sum) == before) return;
            holds = !before;
            link = node.link;
        }
    }

    const CompositeTree<Real>& tree_;
    Memory& memory_;
    std::uint64_t line_;
    std::uint64_t step_;
};

}  // namespace lancer
