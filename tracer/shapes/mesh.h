// Meshes: flat arrays and a tree, which all instances of the mesh share.
#pragma once

#include <bit>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "tracer/bvh/traverse.h"
#include "tracer/rays/crossing.h"
#include "tracer/rays/shear.h"
#include "tracer/shapes/traits.h"
#include "tracer/shapes/triangle_leaf.h"

namespace lancer {

/// A mesh of the scene in its own space.
template <class Real>
struct TriangleMesh {
    std::shared_ptr<const Mesh> source;  ///< faces, uvs and their indices
    int exponent = 0;                    ///< `vertices` are those of `source` times 2^exponent
    std::vector<Vec3<Real>> vertices;
    std::vector<Vec3<Real>> normals;  ///< given or averaged, unit; empty if no instance is smooth
    const std::vector<Mesh::Corners>* normal_faces = nullptr;  ///< into `normals`, one per face
    /// The tree over the faces. A child that is a leaf is an index into `leaves`, and not into
    /// `bvh.order`.
    Bvh<Real> bvh;
    std::vector<TriangleLeaf<Real>> leaves;
    std::vector<std::uint8_t>
        inward;  ///< bodies only: 1 for faces whose normal points inside; empty if none does

    TriangleSheet<Real> triangle(std::uint32_t face) const {
        const Mesh::Corners& corner = source->faces[face];
        return {vertices[corner[0]], vertices[corner[1]], vertices[corner[2]], Real(0)};
    }
};

/// One instance of a mesh. Its faces have the numbers of the mesh.
template <class Real>
struct MeshInstance {
    const TriangleMesh<Real>* mesh;
    bool smooth;

    static constexpr SolidTraits traits{.convex = false, .face_by_face = true};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

/// Reports every crossing with the mesh on the interval. The face that the line starts on is left
/// out: the line meets it nowhere else.
template <class Real, class Last, class Report>
void crossings(const MeshInstance<Real>& instance, const Ray<Real>& ray,
               const IntersectionHints& hints, const RayInterval<Real, Last>& interval,
               Report&& report) {
    const TriangleMesh<Real>& mesh = *instance.mesh;
    std::optional<Shear<Real>> shear;  // computed at the first leaf
    traverse(mesh.bvh, ray, interval.first, interval.last,
             [&](std::uint32_t index, std::uint32_t count) {
                 if (!shear) {
                     shear = shear_of(ray);
                     shear->noise = edge_noise(ray, mesh.bvh.reach);
                 }
                 const TriangleLeaf<Real>& leaf = mesh.leaves[index];
                 unsigned left = may_meet(leaf, ray, *shear) & ((1U << count) - 1);
                 for (; left != 0; left &= left - 1) {
                     const auto i = static_cast<std::size_t>(std::countr_zero(left));
                     const std::uint32_t face = leaf.face[i];
                     if (face == hints.start_face) continue;
                     TriangleHit<Real> hit;
                     if (intersect_exactly(leaf.triangle(i), ray, *shear, interval, hit)) {
                         const bool inward = !mesh.inward.empty() && mesh.inward[face] != 0;
                         if (report(Crossing<Real>{hit.t, hit.error, face, hit.entering != inward},
                                    hit.u, hit.v))
                             return true;
                     }
                 }
                 return false;
             });
}

/// The interpolated normal at the barycentric coordinates u, v; the geometric normal if the face
/// has no others.
template <class Real>
Vec3<Real> shading_normal(const MeshInstance<Real>& instance, std::uint32_t face, Real u, Real v,
                          const Vec3<Real>& geometric) {
    const TriangleMesh<Real>& mesh = *instance.mesh;
    if (!instance.smooth || mesh.normals.empty()) return geometric;
    const Mesh::Corners& corner = (*mesh.normal_faces)[face];
    if (corner[0] == none || corner[1] == none || corner[2] == none) return geometric;
    const Vec3<Real> sum = (1 - u - v) * mesh.normals[corner[0]] + u * mesh.normals[corner[1]] +
                           v * mesh.normals[corner[2]];
    return length_squared(sum) > 0 ? sum : geometric;
}

}  // namespace lancer
