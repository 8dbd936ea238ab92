#include "model/open_edges.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/bodies.h"

namespace lancer {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edge_of(const Mesh::Corners& face, std::size_t i, const std::vector<std::uint32_t>& vertex) {
    return std::minmax({vertex[face[i]], vertex[face[(i + 1) % 3]]});
}

}  // namespace

OpenEdges open_edges(const Mesh& mesh) {
    const std::vector<std::uint32_t> vertex = first_at_same_place(mesh.vertices);
    std::vector<Edge> edges;
    edges.reserve(mesh.faces.size() * 3);
    for (const Mesh::Corners& face : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i) edges.push_back(edge_of(face, i, vertex));
    std::sort(edges.begin(), edges.end());
    OpenEdges open;
    for (auto edge = edges.begin(); edge != edges.end();) {
        const auto next =
            std::find_if(edge, edges.end(), [&](const auto& e) { return e != *edge; });
        if (next - edge != 2) ++open.count;
        edge = next;
    }
    if (open.count == 0) return open;
    for (const Mesh::Corners& face : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [first, last] =
                std::equal_range(edges.begin(), edges.end(), edge_of(face, i, vertex));
            if (last - first == 2) continue;
            open.faces = static_cast<std::uint64_t>(last - first);
            open.begin = mesh.vertices[face[i]];
            open.end = mesh.vertices[face[(i + 1) % 3]];
            return open;
        }
    }
    return open;
}

}  // namespace lancer
