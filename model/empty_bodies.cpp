#include "model/empty_bodies.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/affine.h"
#include "model/extent.h"

namespace lancer {
namespace {

class Tree {
  public:
    Tree(const Scene& scene, const Composite& composite)
        : scene_(scene), composite_(composite), children_(composite.nodes.size()) {
        for (std::uint32_t i = 0; i < composite.leaves.size(); ++i)
            add(composite.leaves[i].place, {i, true});
        for (std::uint32_t i = 1; i < composite.nodes.size(); ++i)
            add(composite.nodes[i].place, {i, false});
    }

    Emptiness emptiness() const { return known({0, false}).empty; }

  private:
    struct Child {
        std::uint32_t index = 0;
        bool is_leaf = false;
    };
    /// What is known of a child: its bounding box, or that it is empty.
    struct Known {
        Extent box;
        Emptiness empty = Emptiness::not_known;

        bool is_empty() const { return empty != Emptiness::not_known; }
    };

    void add(const Composite::Place& place, Child child) {
        auto& siblings = children_[place.parent];
        siblings.insert(place.first ? siblings.begin() : siblings.end(), child);
    }

    Known known(Child child) const {
        if (child.is_leaf) return {leaf_box(composite_.leaves[child.index].object)};
        const auto& parts = children_[child.index];
        if (parts.empty()) return {};
        Known whole = known(parts.front());
        for (std::size_t i = 1; i < parts.size(); ++i)
            add_part(composite_.nodes[child.index].kind, parts.front(), parts[i], whole);
        return whole;
    }

    /// Adds one more part to what is known of a node's parts so far.
    void add_part(Composite::Kind kind, Child first, Child next, Known& whole) const {
        if (kind == Composite::Kind::subtract) {
            if (!whole.is_empty() && (holds(next, whole.box) || are_equal(first, next)))
                whole.empty = Emptiness::cut_away;
            return;
        }
        const Known part = known(next);
        if (kind == Composite::Kind::unite) {
            if (whole.is_empty()) {
                whole = part;
            } else if (!part.is_empty()) {
                whole.box = joined(whole.box, part.box);
            }
            return;
        }
        if (whole.is_empty()) return;
        if (part.is_empty()) {
            whole = part;
            return;
        }
        whole.box = common(whole.box, part.box);
        if (whole.box.is_inside_out()) whole.empty = Emptiness::apart;
    }

    Extent leaf_box(const Object& leaf) const {
        const Extent own = shape_extent(leaf.shape);
        if (!own.is_finite()) return {};
        const Affine<double>& map = scene_.transforms[leaf.transform];
        return around(map_point(map, (own.min + own.max) * 0.5),
                      map_bound(map, (own.max - own.min) * 0.5));
    }

    /// Whether the child contains the whole box, except for rounding.
    bool holds(Child child, const Extent& box) const {
        if (!box.is_finite()) return false;
        if (child.is_leaf) return leaf_holds(composite_.leaves[child.index].object, box);
        const auto& parts = children_[child.index];
        const auto held = [&](Child part) { return holds(part, box); };
        switch (composite_.nodes[child.index].kind) {
            case Composite::Kind::unite:
                return std::any_of(parts.begin(), parts.end(), held);
            case Composite::Kind::intersect:
                return std::all_of(parts.begin(), parts.end(), held);
            case Composite::Kind::subtract:
                return false;
        }
        return false;
    }

    bool leaf_holds(const Object& leaf, const Extent& box) const {
        const Affine<double> back = inverse(scene_.transforms[leaf.transform]);
        for (int corner = 0; corner < 8; ++corner) {
            Vec3d p;
            for (int i = 0; i < 3; ++i) p[i] = (corner >> i & 1) != 0 ? box.max[i] : box.min[i];
            if (!convex_holds(leaf.shape, map_point(back, p))) return false;
        }
        return true;
    }

    bool are_equal(Child a, Child b) const {
        if (!a.is_leaf || !b.is_leaf) return false;
        const Object& one = composite_.leaves[a.index].object;
        const Object& other = composite_.leaves[b.index].object;
        return one.shape == other.shape &&
               scene_.transforms[one.transform] == scene_.transforms[other.transform];
    }

    const Scene& scene_;
    const Composite& composite_;
    /// of each node; parts that are not subtracted come first
    std::vector<std::vector<Child>> children_;
};

}  // namespace

Emptiness emptiness_of(const Scene& scene, const Composite& composite) {
    return Tree(scene, composite).emptiness();
}

}  // namespace lancer
