// Compiles composites of the scene to trees of the tracer.
#pragma once

#include <cmath>

#include "model/diagnostic.h"
#include "tracer/bvh/build.h"
#include "tracer/compile/primitive_bounds.h"

namespace lancer {

/// The number of faces of a solid. 0 for sheets, which cannot be leaves.
template <class Real>
struct FaceCount {
    std::uint64_t operator()(const BallSolid<Real>&) const { return 1; }
    std::uint64_t operator()(const BoxSolid<Real>&) const { return 6; }
    std::uint64_t operator()(const FrustumSolid<Real>&) const { return 3; }
    std::uint64_t operator()(const TorusSolid<Real>&) const { return 1; }
    std::uint64_t operator()(const HalfSpace<Real>&) const { return 1; }
    std::uint64_t operator()(const TriangleSheet<Real>&) const { return 0; }
    std::uint64_t operator()(const PatchSolid<Real>&) const { return 0; }
    std::uint64_t operator()(const BicubicSolid<Real>&) const { return 0; }
    std::uint64_t operator()(const FacetSolid<Real>&) const { return 0; }
    std::uint64_t operator()(const MeshInstance<Real>& s) const {
        return s.mesh->source->faces.size();
    }
    std::uint64_t operator()(const LatheSolid<Real>& s) const {
        return s.surface->curve.segments();
    }
    std::uint64_t operator()(const PrismSolid<Real>& s) const {
        return s.surface->curve.segments() + 2;
    }
    /// A composite in a composite has been flattened: model/scene.h, Composite.
    std::uint64_t operator()(const CompositeSolid<Real>&) const { return 0; }
};

/// The bounds of a leaf. A half space perpendicular to a coordinate axis is bounded on one side.
template <class Real>
Bounds<Real> leaf_bounds(const Geometry<Real>& geometry, const Primitive<Real>& leaf) {
    const auto* half = std::get_if<HalfSpace<Real>>(&leaf.solid);
    if (half == nullptr) return bounds_of(geometry, leaf);
    Bounds<Real> box = solid_bounds(*half);
    const Vec3<Real>& n = half->normal;
    if ((n.x != 0) + (n.y != 0) + (n.z != 0) != 1) return box;
    Bounds<Real> on;
    on.extend(half->point);
    on = widened(on);
    for (int axis = 0; axis < 3; ++axis) {
        if (n[axis] > 0) box.max[axis] = on.max[axis];
        if (n[axis] < 0) box.min[axis] = on.min[axis];
    }
    return box;
}

/// The bounds of the whole, from the bounds of the leaves.
template <class Real>
Bounds<Real> composite_bounds(const Composite& from, const std::vector<Bounds<Real>>& leaves) {
    using Kind = Composite::Kind;
    const Real infinity = std::numeric_limits<Real>::infinity();
    std::vector<Bounds<Real>> nodes(from.nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (from.nodes[i].kind != Kind::unite)
            nodes[i] = around(Vec3<Real>(0), Vec3<Real>(infinity));
    const auto add = [&](const Composite::Place& place, const Bounds<Real>& box) {
        if (place.parent == none) return;
        Bounds<Real>& whole = nodes[place.parent];
        const Kind kind = from.nodes[place.parent].kind;
        if (kind == Kind::unite) {
            whole.extend(box);
        } else if (kind == Kind::intersect || place.first) {
            for (int axis = 0; axis < 3; ++axis) {
                whole.min[axis] = std::max(whole.min[axis], box.min[axis]);
                whole.max[axis] = std::min(whole.max[axis], box.max[axis]);
            }
        }
    };
    for (std::size_t i = 0; i < leaves.size(); ++i) add(from.leaves[i].place, leaves[i]);
    for (std::size_t i = nodes.size(); i-- > 0;) add(from.nodes[i].place, nodes[i]);
    return nodes.front();
}

/// Makes the tree of one composite from its compiled leaves.
template <class Real>
class CompositeCompiler {
  public:
    CompositeCompiler(const Composite& from, const Geometry<Real>& geometry) : from_(from) {
        tree_.frames = &geometry.frames;
    }

    /// Adds the next leaf.
    void add(const Primitive<Real>& primitive) {
        const Composite::Place& place = from_.leaves[tree_.leaves.size()].place;
        CompositeLeaf<Real> leaf;
        leaf.primitive = primitive;
        leaf.link = link_of(place);
        leaf.first_face = static_cast<std::uint32_t>(faces_);
        leaf.subtracted = is_subtracted(place);
        leaf.around = is_around(place);
        faces_ += std::visit(FaceCount<Real>{}, primitive.solid);
        tree_.leaves.push_back(leaf);
    }

    CompositeTree<Real> finish(const Geometry<Real>& geometry, const SourceSpan& place,
                               int threads) {
        if (faces_ >= hidden_face)
            throw SceneError(place, "the parts of this body have more than 2 billion faces");
        add_nodes();
        std::vector<Bounds<Real>> boxes;
        std::vector<Bounds<Real>> in_tree;
        std::vector<std::uint32_t> bounded;
        for (std::uint32_t i = 0; i < tree_.leaves.size(); ++i) {
            const Primitive<Real>& leaf = tree_.leaves[i].primitive;
            boxes.push_back(leaf_bounds(geometry, leaf));
            if (std::holds_alternative<HalfSpace<Real>>(leaf.solid)) {
                tree_.half_spaces.push_back(i);
            } else {
                bounded.push_back(i);
                in_tree.push_back(boxes.back());
            }
        }
        tree_.bvh = build_bvh(std::move(in_tree), 2, threads);
        for (const std::uint32_t item : tree_.bvh.order) tree_.bounded.push_back(bounded[item]);
        tree_.bounds = composite_bounds(from_, boxes);
        return std::move(tree_);
    }

  private:
    CompositeLink link_of(const Composite::Place& place) const {
        CompositeLink link;
        link.parent = place.parent;
        if (place.parent != none && from_.nodes[place.parent].kind == Composite::Kind::subtract)
            link.weight = place.first ? 1 : 2;
        return link;
    }

    bool is_subtracted(Composite::Place place) const {
        bool subtracted = false;
        for (; place.parent != none; place = from_.nodes[place.parent].place)
            subtracted ^= link_of(place).weight == 2;
        return subtracted;
    }

    /// Whether the whole contains no point that is outside of the leaf: there are no unions above
    /// it, and it is never taken away.
    bool is_around(Composite::Place place) const {
        for (; place.parent != none; place = from_.nodes[place.parent].place) {
            const Composite::Kind kind = from_.nodes[place.parent].kind;
            if (kind == Composite::Kind::unite) return false;
            if (kind == Composite::Kind::subtract && !place.first) return false;
        }
        return true;
    }

    void add_nodes() {
        std::vector<std::uint32_t> children(from_.nodes.size());
        for (const Composite::Leaf& leaf : from_.leaves) ++children[leaf.place.parent];
        for (const Composite::Node& node : from_.nodes)
            if (node.place.parent != none) ++children[node.place.parent];
        for (std::size_t i = 0; i < from_.nodes.size(); ++i) {
            CompositeNode node;
            node.link = link_of(from_.nodes[i].place);
            if (from_.nodes[i].kind == Composite::Kind::intersect) node.low = children[i];
            if (from_.nodes[i].kind == Composite::Kind::subtract) node.high = 1;
            tree_.nodes.push_back(node);
        }
    }

    const Composite& from_;
    CompositeTree<Real> tree_;
    std::uint64_t faces_ = 0;
};

}  // namespace lancer
