#include "model/bodies.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "model/shape_facts.h"

namespace lancer {
std::vector<std::uint32_t> first_at_same_place(const std::vector<Vec3d>& vertices) {
    const auto key = [&vertices](std::uint32_t i) {
        const Vec3d& v = vertices[i];
        return std::tuple(v.x, v.y, v.z, i);
    };
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&key](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> first(vertices.size());
    std::uint32_t current = none;
    for (const std::uint32_t i : order) {
        if (current == none || vertices[i] != vertices[current]) current = i;
        first[i] = current;
    }
    return first;
}

bool is_closed(const Mesh& mesh) {
    const std::vector<std::uint32_t> vertex = first_at_same_place(mesh.vertices);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(mesh.faces.size() * 3);
    for (const Mesh::Corners& face : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i)
            edges.push_back(std::minmax({vertex[face[i]], vertex[face[(i + 1) % 3]]}));
    }
    std::sort(edges.begin(), edges.end());
    for (auto edge = edges.begin(); edge != edges.end();) {
        const auto next =
            std::find_if(edge, edges.end(), [&](const auto& e) { return e != *edge; });
        if (next - edge != 2) return false;
        edge = next;
    }
    return !edges.empty();
}

bool is_body(const Scene& scene, const Shape& shape) {
    const ShapeFacts facts = facts_of(scene, shape);
    return facts.inside ? *facts.inside : is_closed(*scene.meshes[std::get<MeshRef>(shape).mesh]);
}

bool Bodies::holds(const Shape& shape) {
    const auto* mesh = std::get_if<MeshRef>(&shape);
    if (mesh == nullptr || mesh->inside != Inside::if_closed) return is_body(scene_, shape);
    const auto [known, is_new] = closed_.try_emplace(mesh->mesh, false);
    if (is_new) known->second = is_body(scene_, shape);
    return known->second;
}

}  // namespace lancer
