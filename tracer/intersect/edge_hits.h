// Edges and corners of a mesh: a ray that one face refracts or mirrors may go straight through the
// adjacent face.
#pragma once

#include <optional>

#include "tracer/intersect/nearest_contact.h"
#include "tracer/rays/crossing.h"

namespace lancer {

/// A face of a mesh in the mesh's own space, with a unit normal that points out of the body.
template <class Real>
struct OrientedFace {
    TriangleSheet<Real> triangle;
    Vec3<Real> outward;

    OrientedFace(const TriangleMesh<Real>& mesh, std::uint32_t face)
        : triangle(mesh.triangle(face)) {
        const Vec3<Real> n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
        outward = normalize(n / max_component(absolute(n)));
        if (!mesh.inward.empty() && mesh.inward[face] != 0) outward = -outward;
    }
};

/// Barycentric coordinates of the second and third corner at the point of the triangle's plane that
/// is nearest to `point`.
template <class Real>
Vec2<Real> weights_at(const TriangleSheet<Real>& triangle, const Vec3<Real>& point) {
    const Vec3<Real> ab = triangle.b - triangle.a;
    const Vec3<Real> ac = triangle.c - triangle.a;
    const Vec3<Real> n = cross(ab, ac);
    const Vec3<Real> rel = point - triangle.a;
    const Real square = length_squared(n);
    return {dot(cross(rel, ac), n) / square, dot(cross(ab, rel), n) / square};
}

/// Whether the point, which lies on the triangle, is within `reach` of one of its edges.
template <class Real>
bool is_near_edge(const TriangleSheet<Real>& triangle, const Vec3<Real>& point, Real reach) {
    const Vec3<Real> ab = triangle.b - triangle.a;
    const Vec3<Real> ac = triangle.c - triangle.a;
    const Vec2<Real> w = weights_at(triangle, point);
    const Real area = length(cross(ab, ac));
    // A barycentric coordinate times the height over its edge is the distance from that edge.
    return w.x * area <= reach * length(ac) || w.y * area <= reach * length(ab) ||
           (1 - w.x - w.y) * area <= reach * length(ac - ab);
}

/// The barycentric coordinates of the triangle's point near `point`; nothing if it is farther than
/// `reach`.
template <class Real>
std::optional<Vec2<Real>> weights_near(const TriangleSheet<Real>& triangle, const Vec3<Real>& point,
                                       Real reach) {
    Vec2<Real> w = weights_at(triangle, point);
    w.x = w.x < 0 ? Real(0) : w.x;
    w.y = w.y < 0 ? Real(0) : w.y;
    if (w.x + w.y > 1) w = w / (w.x + w.y);
    const Vec3<Real> nearest =
        (triangle.a - point) + w.x * (triangle.b - triangle.a) + w.y * (triangle.c - triangle.a);
    if (!(max_component(absolute(nearest)) <= reach)) return std::nullopt;
    return w;
}

/// Whether two faces of a body meet in a convex edge. The other face then lies behind the plane of
/// this one. The corners that they share add only rounding errors to the sum.
template <class Real>
bool is_convex_edge(const OrientedFace<Real>& face, const TriangleSheet<Real>& other) {
    Real height = 0;
    for (const Vec3<Real>& corner : {other.a, other.b, other.c})
        height += dot(face.outward, corner - face.triangle.a);
    return height < 0;
}

/// Calls visit(face) for every face whose box is within `reach` of the point.
template <class Real, class Visit>
void faces_near(const TriangleMesh<Real>& mesh, const Vec3<Real>& point, Real reach,
                Visit&& visit) {
    std::vector<std::uint32_t> waiting{0};
    while (!waiting.empty()) {
        const BvhNode<Real>& node = mesh.bvh.nodes[waiting.back()];
        waiting.pop_back();
        for (std::size_t c = 0; c < node.child.size(); ++c) {
            if (node.child[c] == none) continue;
            bool holds = true;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Real x = point[static_cast<int>(axis)];
                holds = holds && x >= node.min[axis][c] - reach && x <= node.max[axis][c] + reach;
            }
            if (!holds) continue;
            if (node.count[c] == 0) waiting.push_back(node.child[c]);
            for (std::uint32_t i = 0; i < node.count[c]; ++i)
                visit(mesh.leaves[node.child[c]].face[i]);
        }
    }
}

/// A ray that starts on a face of a mesh that is a medium, in the mesh's own space.
template <class Real>
class AdjacentFaces {
  public:
    /// \param start  the face that the ray starts on
    AdjacentFaces(const TriangleMesh<Real>& mesh, const Ray<Real>& local, const SurfaceId& start,
                  bool inside)
        : mesh_(mesh),
          from_(mesh, start.face),
          start_(start),
          at_(local.origin + local.origin_lo),
          dir_(local.dir),
          inside_(inside) {
        // origin_error bounds the start's distance from the face. Its error along the face, and
        // the errors of crossings computed from it, grow with the sizes of the face and of the
        // coordinates.
        const Real size = max_component(absolute(from_.triangle.b - from_.triangle.a)) +
                          max_component(absolute(from_.triangle.c - from_.triangle.a));
        reach_ = 4 * local.origin_error + gamma<Real>(16) * (max_component(absolute(at_)) + size);
    }

    /// How far beside an edge the start may be for a hit.
    Real reach() const { return reach_; }

    /// The hit of the adjacent face that the ray crosses most steeply, with a start at most `reach`
    /// beside the edge; empty if there is none.
    Contact<Real> hit(Real reach) const {
        Contact<Real> met;
        if (!is_near_edge(from_.triangle, at_, reach)) return met;
        Real steepest = 0;
        faces_near(mesh_, at_, reach, [&](std::uint32_t index) {
            if (index == start_.face) return;
            const OrientedFace<Real> face(mesh_, index);
            const Real out = (inside_ ? 1 : -1) * dot(face.outward, dir_);
            if (!(out > steepest) || is_convex_edge(from_, face.triangle) != inside_) return;
            const auto weights = weights_near(face.triangle, at_, reach);
            if (!weights) return;
            steepest = out;
            const SurfaceId surface{start_.primitive, index, !inside_};
            met.assign(1, Hit<Real>{0, reach, surface, weights->x, weights->y});
        });
        return met;
    }

  private:
    const TriangleMesh<Real>& mesh_;
    OrientedFace<Real> from_;
    SurfaceId start_;
    Vec3<Real> at_;
    Vec3<Real> dir_;
    bool inside_;
    Real reach_;
};

/// Calls work(AdjacentFaces) if the ray starts on a mesh that is a medium; else returns no hit.
///
/// \param turn    the face that refracted or mirrored the ray
/// \param bodies  that contain the ray
template <class Real, class Work>
Contact<Real> with_adjacent_faces(const World<Real>& world, const Ray<Real>& ray,
                                  const SurfaceId& turn, const MediaList& bodies, Work&& work) {
    if (turn.primitive == none) return {};
    const Primitive<Real>& primitive = world.primitives[turn.primitive];
    const auto* instance = std::get_if<MeshInstance<Real>>(&primitive.solid);
    if (instance == nullptr || !primitive.medium) return {};
    const bool inside = contains(bodies, turn.primitive);
    if (primitive.frame == none)
        return work(AdjacentFaces<Real>(*instance->mesh, ray, turn, inside));
    const Ray<Real> local = to_local(ray, world.frames[primitive.frame]);
    return work(AdjacentFaces<Real>(*instance->mesh, local, turn, inside));
}

/// The adjacent face hit of a ray that a face of a mesh refracted or mirrored; empty if there is
/// none. If the distance between the ray's start and an edge is below the rounding error, the ray
/// may go straight through the face behind that edge: out of the body at a convex edge, into it at
/// a concave one. The search may miss both faces by rounding. So this function takes the side from
/// the ray's list of bodies.
template <class Real>
Contact<Real> adjacent_face_hit(const World<Real>& world, const Ray<Real>& ray,
                                const SurfaceId& turn, const MediaList& bodies) {
    return with_adjacent_faces(world, ray, turn, bodies, [](const AdjacentFaces<Real>& faces) {
        return faces.hit(faces.reach());
    });
}

/// The same for a ray that a search lost in the body it starts on: the nearest adjacent face.
///
/// Where a ray meets a face at a small angle, the error of its start along the face is the error
/// of its distance over that angle, and adjacent_face_hit() does not know the angle. At less than
/// the square root of the roundings, rounding decides whether the ray meets the face at all.
template <class Real>
Contact<Real> lost_face_hit(const World<Real>& world, const Ray<Real>& ray, const SurfaceId& turn,
                            const MediaList& bodies) {
    using std::sqrt;
    return with_adjacent_faces(world, ray, turn, bodies, [](const AdjacentFaces<Real>& faces) {
        Contact<Real> met;
        const Real farthest = faces.reach() / sqrt(gamma<Real>(16));
        for (Real reach = 8 * faces.reach(); met.empty() && reach <= farthest; reach *= 8)
            met = faces.hit(reach);
        return met;
    });
}

}  // namespace lancer
