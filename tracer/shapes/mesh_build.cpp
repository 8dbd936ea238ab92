#include "tracer/shapes/mesh_build.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "model/bodies.h"

namespace lancer {
namespace {

/// Six times the enclosed volume, in units of the mesh's size. Only its sign is used.
double signed_volume(const Mesh& mesh, const std::vector<std::uint8_t>& turned) {
    const Vec3d origin = mesh.vertices[mesh.faces.front()[0]];
    double size = 0;
    for (const Vec3d& v : mesh.vertices) size = std::max(size, max_component(absolute(v - origin)));
    double volume = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const Mesh::Corners& f = mesh.faces[i];
        const Vec3d a = (mesh.vertices[f[0]] - origin) / size;
        const Vec3d b = (mesh.vertices[f[1]] - origin) / size;
        const Vec3d c = (mesh.vertices[f[2]] - origin) / size;
        volume += dot(a, cross(b, c)) * (turned[i] ? -1 : 1);
    }
    return volume;
}

struct Edge {
    std::uint32_t low, high;  ///< its vertices
    std::uint32_t face;
    bool upward;  ///< the face goes from low to high
};

}  // namespace

std::vector<std::uint8_t> inward_faces(const Mesh& mesh) {
    const std::vector<std::uint32_t> vertex = first_at_same_place(mesh.vertices);
    std::vector<Edge> edges;
    edges.reserve(mesh.faces.size() * 3);
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = vertex[mesh.faces[f][i]];
            const std::uint32_t b = vertex[mesh.faces[f][(i + 1) % 3]];
            edges.push_back({std::min(a, b), std::max(a, b), f, a < b});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tuple(a.low, a.high, a.face) < std::tuple(b.low, b.high, b.face);
    });
    // The mesh is closed, so equal edges form pairs. Each face gets its three neighbours, and
    // whether their winding agrees with its own.
    struct Neighbour {
        std::uint32_t face;
        bool agrees;
    };
    std::vector<std::array<Neighbour, 3>> neighbours(mesh.faces.size());
    std::vector<std::uint8_t> filled(mesh.faces.size(), 0);
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        const Edge& a = edges[i];
        const Edge& b = edges[i + 1];
        const bool agrees = a.upward != b.upward;
        neighbours[a.face][filled[a.face]++] = {b.face, agrees};
        neighbours[b.face][filled[b.face]++] = {a.face, agrees};
    }
    constexpr std::uint8_t unseen = 2;
    std::vector<std::uint8_t> turned(mesh.faces.size(), unseen);
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t first = 0; first < mesh.faces.size(); ++first) {
        if (turned[first] != unseen) continue;
        turned[first] = 0;
        waiting.push_back(first);
        while (!waiting.empty()) {
            const std::uint32_t face = waiting.back();
            waiting.pop_back();
            for (const Neighbour& n : neighbours[face]) {
                if (turned[n.face] != unseen) continue;
                turned[n.face] = n.agrees ? turned[face] : std::uint8_t(1 - turned[face]);
                waiting.push_back(n.face);
            }
        }
    }
    if (signed_volume(mesh, turned) < 0) {
        for (std::uint8_t& t : turned) t = std::uint8_t(1 - t);
    }
    if (std::find(turned.begin(), turned.end(), 1) == turned.end()) turned.clear();
    return turned;
}

}  // namespace lancer
