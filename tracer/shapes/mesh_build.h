// Compiles meshes: scaled, with normals if an instance is smooth, and with a tree.
#pragma once

#include <algorithm>
#include <memory>

#include "base/parallel.h"
#include "tracer/bvh/build.h"
#include "tracer/numerics/power_of_two.h"
#include "tracer/shapes/mesh.h"

namespace lancer {

struct MeshNeeds {
    bool normals = false;  ///< some instance interpolates normals
    bool body = false;     ///< rays go through its inside, so the orientation of its faces matters
};

/// Which faces of a closed mesh (model/bodies.h) have normals that point inside: one byte per face,
/// 1 for such faces; empty if there are none. Scripts and scanners often produce inconsistent
/// winding. So faces are turned to agree with their neighbours, and then all together so that the
/// enclosed volume is positive. For a mesh with gaps that its author declares a body, this is the
/// volume of the cones over its faces from one of its vertices.
std::vector<std::uint8_t> inward_faces(const Mesh& mesh);

/// Per vertex the average of the normals of adjacent faces, weighted by area. A vertex whose faces
/// cancel gets 0.
template <class Real>
std::vector<Vec3<Real>> averaged_normals(const TriangleMesh<Real>& mesh) {
    std::vector<Vec3<Real>> normals(mesh.vertices.size(), Vec3<Real>(0));
    for (const Mesh::Corners& face : mesh.source->faces) {
        const Vec3<Real>& a = mesh.vertices[face[0]];
        const Vec3<Real> twice_area = cross(mesh.vertices[face[1]] - a, mesh.vertices[face[2]] - a);
        for (const std::uint32_t corner : face) normals[corner] += twice_area;
    }
    for (Vec3<Real>& n : normals) {
        const Real size = max_component(absolute(n));
        if (size > 0) n = normalize(n / size);
    }
    return normals;
}

template <class Real>
std::vector<Vec3<Real>> given_normals(const Mesh& mesh) {
    std::vector<Vec3<Real>> normals;
    normals.reserve(mesh.normals.size());
    for (const Vec3d& given : mesh.normals) {
        const double size = max_component(absolute(given));
        normals.push_back(size > 0 ? normalize(convert<Real>(given / size)) : Vec3<Real>(0));
    }
    return normals;
}

template <class Real>
std::vector<Bounds<Real>> face_boxes(const TriangleMesh<Real>& mesh) {
    std::vector<Bounds<Real>> boxes;
    boxes.reserve(mesh.source->faces.size());
    for (const Mesh::Corners& face : mesh.source->faces) {
        Bounds<Real> box;
        for (const std::uint32_t corner : face) box.extend(mesh.vertices[corner]);
        boxes.push_back(box);
    }
    return boxes;
}

/// Fills mesh.leaves with the faces of the tree's leaves, in the order of the nodes.
template <class Real>
void gather_leaves(TriangleMesh<Real>& mesh, int threads) {
    // Ranges of nodes for the threads; first[i] is the number of the first leaf of range i.
    std::vector<BvhNode<Real>>& nodes = mesh.bvh.nodes;
    constexpr std::size_t stretch = 4096;
    std::vector<std::uint32_t> first;
    std::uint32_t leaves = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (i % stretch == 0) first.push_back(leaves);
        for (const std::uint32_t count : nodes[i].count) leaves += count != 0;
    }
    mesh.leaves.resize(leaves);
    const auto gather = [&](std::size_t number) {
        std::uint32_t next = first[number];
        const std::size_t end = std::min(nodes.size(), (number + 1) * stretch);
        for (std::size_t n = number * stretch; n < end; ++n) {
            BvhNode<Real>& node = nodes[n];
            for (std::size_t c = 0; c < node.child.size(); ++c) {
                if (node.count[c] == 0) continue;
                TriangleLeaf<Real>& leaf = mesh.leaves[next];
                for (std::uint32_t i = 0; i < node.count[c]; ++i) {
                    const std::uint32_t face = mesh.bvh.order[node.child[c] + i];
                    leaf.set(i, face, mesh.triangle(face));
                }
                node.child[c] = next++;
            }
        }
    };
    if (first.size() <= 1) threads = 1;
    if (threads <= 1) {
        for (std::size_t i = 0; i < first.size(); ++i) gather(i);
    } else {
        for_each_task(static_cast<int>(first.size()), threads, {}, [&](const NextTask& task) {
            for (int i = 0; task(i);) gather(static_cast<std::size_t>(i));
        });
    }
    mesh.bvh.order = {};
}

/// \param exponent  vertices are multiplied by 2^exponent
template <class Real>
std::unique_ptr<TriangleMesh<Real>> compile_mesh(const std::shared_ptr<const Mesh>& source,
                                                 int exponent, const MeshNeeds& needs,
                                                 int threads) {
    auto mesh = std::make_unique<TriangleMesh<Real>>();
    mesh->source = source;
    mesh->exponent = exponent;
    const Mesh& from = *mesh->source;
    mesh->vertices.reserve(from.vertices.size());
    for (const Vec3d& v : from.vertices)
        mesh->vertices.push_back(convert<Real>(scaled(v, exponent)));
    if (needs.normals) {
        if (from.normals.empty()) {
            mesh->normals = averaged_normals(*mesh);
            mesh->normal_faces = &from.faces;
        } else {
            mesh->normals = given_normals<Real>(from);
            mesh->normal_faces = from.normal_faces.empty() ? &from.faces : &from.normal_faces;
        }
    }
    if (needs.body) mesh->inward = inward_faces(from);
    mesh->bvh = build_bvh(face_boxes(*mesh), TriangleLeaf<Real>::size, threads);
    gather_leaves(*mesh, threads);
    return mesh;
}

}  // namespace lancer
