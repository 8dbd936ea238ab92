// How the faces near an edge are found.
#pragma once

#include <optional>

#include "tracer/intersect/edge_hits.h"

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

template <class Real>
Contact<Real> adjacent_face_hit(const Geometry<Real>& geometry, const Ray<Real>& ray,
                                const SurfaceId& turn, const MediaList& bodies, Real wider) {
    Contact<Real> met;
    if (turn.primitive == none) return met;
    const Primitive<Real>& primitive = geometry.primitives[turn.primitive];
    const auto* instance = std::get_if<MeshInstance<Real>>(&primitive.solid);
    if (instance == nullptr || !primitive.medium) return met;
    const TriangleMesh<Real>& mesh = *instance->mesh;
    const Ray<Real> local =
        primitive.frame == none ? ray : to_local(ray, geometry.frames[primitive.frame]);
    const Vec3<Real> start = local.origin + local.origin_lo;
    const OrientedFace<Real> from(mesh, turn.face);
    // origin_error bounds the start's distance from the face. Its error along the face, and the
    // errors of crossings computed from it, grow with the sizes of the face and of the coordinates.
    const Real size = max_component(absolute(from.triangle.b - from.triangle.a)) +
                      max_component(absolute(from.triangle.c - from.triangle.a));
    const Real reach = wider * (4 * local.origin_error +
                                gamma<Real>(16) * (max_component(absolute(start)) + size));
    if (!is_near_edge(from.triangle, start, reach)) return met;
    const bool inside = contains(bodies, turn.primitive);
    Real steepest = 0;
    faces_near(mesh, start, reach, [&](std::uint32_t index) {
        if (index == turn.face) return;
        const OrientedFace<Real> face(mesh, index);
        const Real out = (inside ? 1 : -1) * dot(face.outward, local.dir);
        if (!(out > steepest) || is_convex_edge(from, face.triangle) != inside) return;
        const auto weights = weights_near(face.triangle, start, reach);
        if (!weights) return;
        steepest = out;
        met.assign(1,
                   Hit<Real>{0, reach, {turn.primitive, index, !inside}, weights->x, weights->y});
    });
    return met;
}

template <class Real>
Contact<Real> lost_face_hit(const Geometry<Real>& geometry, const Ray<Real>& ray,
                            const SurfaceId& turn, const MediaList& bodies) {
    using std::sqrt;
    Contact<Real> met;
    const Real widest = 1 / sqrt(gamma<Real>(16));
    for (Real wider = 8; met.empty() && wider <= widest; wider *= 8)
        met = adjacent_face_hit(geometry, ray, turn, bodies, wider);
    return met;
}

}  // namespace lancer
