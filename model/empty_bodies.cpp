#include "model/empty_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "model/affine.h"

namespace lancer {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

Vec3d least(const Vec3d& a, const Vec3d& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3d most(const Vec3d& a, const Vec3d& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// A box that holds a body.
struct Extent {
    Vec3d min{-inf, -inf, -inf};
    Vec3d max{inf, inf, inf};

    bool is_empty() const { return min.x >= max.x || min.y >= max.y || min.z >= max.z; }
    bool is_finite() const { return std::isfinite(dot(min, min) + dot(max, max)); }
};

Extent around(const Vec3d& center, const Vec3d& half) {
    return {center - half, center + half};
}

/// Round a disc across `axis`.
Extent round_disc(const Vec3d& center, const Vec3d& axis, double radius) {
    Vec3d half;
    for (int i = 0; i < 3; ++i)
        half[i] = radius * std::sqrt(std::max(0.0, 1 - axis[i] * axis[i] / dot(axis, axis)));
    return around(center, half);
}

Extent joined(const Extent& a, const Extent& b) {
    return {least(a.min, b.min), most(a.max, b.max)};
}

/// Shapes that are not named have no box here, so nothing is concluded from them.
struct ExtentOf {
    const Scene& scene;

    Extent operator()(const Sphere& s) const { return around(s.center, Vec3d(s.radius)); }
    Extent operator()(const Box& b) const { return {b.min, b.max}; }
    Extent operator()(const Cylinder& c) const {
        return joined(round_disc(c.base, c.top - c.base, c.radius),
                      round_disc(c.top, c.top - c.base, c.radius));
    }
    Extent operator()(const Cone& c) const {
        return joined(round_disc(c.base, c.top - c.base, c.base_radius),
                      round_disc(c.top, c.top - c.base, c.top_radius));
    }
    Extent operator()(const Torus& t) const {
        const double r = t.radius + t.tube;
        return {{-r, -t.tube, -r}, {r, t.tube, r}};
    }
    Extent operator()(const MeshRef& m) const {
        const auto& vertices = scene.meshes[m.mesh]->vertices;
        Extent all{vertices.front(), vertices.front()};
        for (const Vec3d& v : vertices) all = joined(all, {v, v});
        return all;
    }
    template <class Other>
    Extent operator()(const Other&) const {
        return {};
    }
};

/// The axis from `base` to `top` at the height of `p`: 0 at the base, 1 at the top; and the
/// distance of `p` from it.
std::pair<double, double> on_axis(const Vec3d& base, const Vec3d& top, const Vec3d& p) {
    const Vec3d axis = top - base;
    const double height = dot(p - base, axis) / dot(axis, axis);
    return {height, length(p - base - axis * height)};
}

/// Whether a convex solid holds the point.
struct Holds {
    const Vec3d& p;

    bool operator()(const Sphere& s) const { return length(p - s.center) <= s.radius; }
    bool operator()(const Box& b) const {
        return least(p, b.min) == b.min && most(p, b.max) == b.max;
    }
    bool operator()(const Plane& s) const {
        return dot(s.normal, p) <= s.offset * length(s.normal);
    }
    bool operator()(const Cylinder& c) const {
        const auto [height, distance] = on_axis(c.base, c.top, p);
        return 0 <= height && height <= 1 && distance <= c.radius;
    }
    bool operator()(const Cone& c) const {
        const auto [height, distance] = on_axis(c.base, c.top, p);
        return 0 <= height && height <= 1 &&
               distance <= c.base_radius + (c.top_radius - c.base_radius) * height;
    }
    template <class Other>
    bool operator()(const Other&) const {
        return false;
    }
};

class Tree {
  public:
    Tree(const Scene& scene, const Composite& composite)
        : scene_(scene), composite_(composite), children_(composite.nodes.size()) {
        for (std::uint32_t i = 0; i < composite.leaves.size(); ++i)
            add(composite.leaves[i].place, {i, true});
        for (std::uint32_t i = 1; i < composite.nodes.size(); ++i)
            add(composite.nodes[i].place, {i, false});
    }

    bool is_empty() const { return !extent({0, false}); }

  private:
    struct Child {
        std::uint32_t index = 0;
        bool is_leaf = false;
    };

    void add(const Composite::Place& place, Child child) {
        auto& siblings = children_[place.parent];
        siblings.insert(place.first ? siblings.begin() : siblings.end(), child);
    }

    /// A box that holds the child; nothing where it is surely empty.
    std::optional<Extent> extent(Child child) const {
        if (child.is_leaf) return leaf_extent(composite_.leaves[child.index].object);
        const auto& parts = children_[child.index];
        if (parts.empty()) return {};
        std::optional<Extent> whole = extent(parts.front());
        const Composite::Kind kind = composite_.nodes[child.index].kind;
        for (std::size_t i = 1; i < parts.size(); ++i) {
            if (kind == Composite::Kind::subtract) {
                if (whole && (holds(parts[i], *whole) || are_equal(parts.front(), parts[i])))
                    whole.reset();
                continue;
            }
            const std::optional<Extent> part = extent(parts[i]);
            if (kind == Composite::Kind::unite) {
                if (!whole || !part) {
                    if (!whole) whole = part;
                } else {
                    whole = joined(*whole, *part);
                }
            } else if (!whole || !part) {
                return {};
            } else {
                whole = Extent{most(whole->min, part->min), least(whole->max, part->max)};
                if (whole->is_empty()) return {};
            }
        }
        return whole;
    }

    Extent leaf_extent(const Object& leaf) const {
        const Extent own = std::visit(ExtentOf{scene_}, leaf.shape);
        if (!own.is_finite()) return {};
        const Affine<double>& map = scene_.transforms[leaf.transform];
        return around(map_point(map, (own.min + own.max) * 0.5),
                      map_bound(map, (own.max - own.min) * 0.5));
    }

    /// Whether all of the box lies in the child. Rounding may decide for a box that touches from
    /// within; then at most a skin of one rounding is left.
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
            if (!std::visit(Holds{map_point(back, p)}, leaf.shape)) return false;
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
    std::vector<std::vector<Child>> children_;  ///< of each node; what is not subtracted first
};

}  // namespace

bool is_surely_empty(const Scene& scene, const Composite& composite) {
    return Tree(scene, composite).is_empty();
}

}  // namespace lancer
