// The crossings of a line with the leaves of a composite.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>

#include "tracer/bvh/traverse.h"
#include "tracer/intersect/composite_state.h"
#include "tracer/intersect/intersection_filter.h"
#include "tracer/intersect/shape_crossings.h"

namespace lancer {

/// A crossing of a leaf.
template <class Real>
struct CompositeEvent {
    Real t, error;
    Real u, v;  ///< triangles only
    std::uint32_t leaf;
    std::uint32_t face;  ///< of the leaf
    bool entering;
};

template <class Real>
using CompositeEvents = boost::container::small_vector<CompositeEvent<Real>, 16>;

/// Whether a body counts as containing the plane of a flat face, for lines that run within the
/// plane. No crossing shows on which side of the face such a line runs. The face therefore counts
/// as moved a little towards lower x; towards lower y if it contains the x direction, and towards
/// lower z if it contains both. So the line is in exactly one of two bodies glued at the face.
template <class Real>
bool holds_its_plane(const Vec3<Real>& outward) {
    for (int axis = 0; axis < 3; ++axis) {
        if (outward[axis] != 0) return outward[axis] < 0;
    }
    return false;
}

/// Whether the line runs within a flat face whose body does not contain the plane
/// (holds_its_plane). For a box.
template <class Real>
bool runs_beside(const BoxSolid<Real>& box, const Ray<Real>& ray) {
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.dir[axis] == 0 && to_planes(box, ray, axis).numbers()[1] == 0) return true;
    }
    return false;
}

/// The same for a cap of a cylinder or cone along a coordinate axis.
template <class Real>
bool runs_beside(const FrustumSolid<Real>& f, const Ray<Real>& ray) {
    if (f.tilted || !(dot(f.axis, ray.dir) == 0)) return false;
    const bool in_small = dot(f.axis, start_from(ray, f.small_end)) == 0;
    const bool in_large = dot(f.axis, start_from(ray, f.large_end)) == 0;
    return (in_small && !holds_its_plane(-f.axis)) || (in_large && !holds_its_plane(f.axis));
}

// Balls and tori have no flat faces. Triangles and splines have crossings for such lines as well.
template <class Real>
bool runs_beside(const BallSolid<Real>&, const Ray<Real>&) {
    return false;
}
template <class Real>
bool runs_beside(const TorusSolid<Real>&, const Ray<Real>&) {
    return false;
}
template <class Real>
bool runs_beside(const MeshInstance<Real>&, const Ray<Real>&) {
    return false;
}
template <class Real>
bool runs_beside(const LatheSolid<Real>&, const Ray<Real>&) {
    return false;
}
template <class Real>
bool runs_beside(const PrismSolid<Real>&, const Ray<Real>&) {
    return false;
}

/// False for half spaces, which have their own search; for sheets, which cannot be leaves; and for
/// composites, whose parts become leaves when they are compiled.
template <class S, class Real>
inline constexpr bool has_crossings_as_leaf =
    !(std::is_same_v<S, HalfSpace<Real>> || std::is_same_v<S, TriangleSheet<Real>> ||
      std::is_same_v<S, PatchSolid<Real>> || std::is_same_v<S, BicubicSolid<Real>> ||
      std::is_same_v<S, FacetSolid<Real>> || std::is_same_v<S, CompositeSolid<Real>>);

/// Finds the crossings of a line with a composite's leaves.
template <class Real>
class CompositeSearch {
  public:
    /// \param first  crossings that lie before this parameter by more than their error may be
    ///               missing
    /// \param start  the faces that the line starts on; may be null
    CompositeSearch(const CompositeTree<Real>& tree, const Ray<Real>& ray, Real first,
                    const SurfaceList* start, std::uint32_t primitive)
        : tree_(tree), ray_(ray), first_(first) {
        if (start == nullptr) return;
        for (const SurfaceId& s : *start) {
            if (s.primitive != primitive) continue;
            const std::uint32_t face = s.face & ~hidden_face;
            const std::uint32_t leaf = tree.leaf_of(face);
            started_.push_back({leaf, face - tree.leaves[leaf].first_face});
        }
    }

    /// Fills `events`, in no order, and sets the leaves that contain the line's far end in `state`.
    void find(CompositeEvents<Real>& events, CompositeState<Real>& state) const {
        for (const std::uint32_t leaf : tree_.half_spaces) add_half_space(leaf, events, state);
        traverse(tree_.bvh, ray_, first_, endless<Real>,
                 [&](std::uint32_t from, std::uint32_t count) {
                     for (std::uint32_t i = from; i < from + count; ++i)
                         add_bounded(tree_.bounded[i], events);
                     return false;
                 });
    }

    bool starts_on(std::uint32_t leaf) const { return start_face(leaf) != none; }

    /// A face that the line starts on, of one of the leaves.
    struct Started {
        std::uint32_t leaf, face;
    };
    using StartedList = boost::container::small_vector<Started, 4>;
    const StartedList& started() const { return started_; }

  private:
    std::uint32_t start_face(std::uint32_t leaf) const {
        for (const Started& s : started_) {
            if (s.leaf == leaf) return s.face;
        }
        return none;
    }

    RayInterval<Real, decltype(endless<Real>)> interval() const { return {first_, endless<Real>}; }

    void add_half_space(std::uint32_t index, CompositeEvents<Real>& events,
                        CompositeState<Real>& state) const {
        const auto& half = *std::get_if<HalfSpace<Real>>(&tree_.leaves[index].primitive.solid);
        const Real slope = dot(half.normal, ray_.dir);
        bool inside_at_end = slope < 0;
        bool crosses = slope != 0;
        if (crosses && !starts_on(index)) {
            const auto report = [&](const Crossing<Real>& c) {
                crosses = c.t - c.t == 0;  // finite
                if (crosses)
                    events.push_back({c.t, c.error, Real(0), Real(0), index, c.face, c.entering});
            };
            crossing(half, ray_, slope, interval(), report);
        }
        if (!crosses) {
            const Real height = dot(half.normal, start_from(ray_, half.point));
            inside_at_end = height < 0;
            if (height == 0 || starts_on(index)) inside_at_end = holds_its_plane(half.normal);
        }
        if (inside_at_end) state.set_depth(index, 1);
    }

    void add_bounded(std::uint32_t index, CompositeEvents<Real>& events) const {
        const Primitive<Real>& leaf = tree_.leaves[index].primitive;
        const bool moved = leaf.frame != none;
        const Ray<Real> ray = moved ? to_local(ray_, (*tree_.frames)[leaf.frame]) : ray_;
        IntersectionHints hints;
        hints.start_face = start_face(index);
        const auto report = [&](const Crossing<Real>& c, Real u, Real v) {
            events.push_back({c.t, c.error, u, v, index, c.face, c.entering});
            return false;
        };
        std::visit(
            [&](const auto& shape) {
                if constexpr (has_crossings_as_leaf<std::decay_t<decltype(shape)>, Real>) {
                    if (runs_beside(shape, ray)) return;
                    if (hints.start_face != none) hints.inside = leads_inside(shape, ray, hints);
                    shape_crossings(shape, ray, hints, interval(), report);
                }
            },
            leaf.solid);
    }

    /// Whether the line leads into the body from the face that it starts on. Only spline bodies and
    /// tori need this hint.
    template <class S>
    static bool leads_inside(const S& shape, const Ray<Real>& ray, const IntersectionHints& hints) {
        if constexpr (std::is_same_v<S, LatheSolid<Real>> || std::is_same_v<S, PrismSolid<Real>> ||
                      std::is_same_v<S, TorusSolid<Real>>)
            return dot(surface_point(shape, ray, Real(0), hints.start_face).normal, ray.dir) < 0;
        return false;
    }

    const CompositeTree<Real>& tree_;
    const Ray<Real>& ray_;
    const Real first_;
    StartedList started_;
};

}  // namespace lancer
