#include "model/smoothing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "model/elementary.h"
#include "model/math.h"

namespace lancer {
namespace {

/// The faces' normals and areas, and the corners at each vertex.
class Neighbours {
  public:
    Neighbours(const Mesh& mesh, double degrees) : mesh_(mesh) {
        // The rounding of the normals must not make an edge of exactly `degrees` sharp.
        constexpr double rounding = 1e-14;
        least_cosine_ = elementary::sine_cosine_of_degrees(degrees).cosine - rounding;
        double largest = 0;
        for (const Vec3d& v : mesh.vertices)
            largest = std::max(largest, max_component(absolute(v)));
        const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
        const auto scaled = [exponent](const Vec3d& v) {
            return Vec3d(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent),
                         std::ldexp(v.z, exponent));
        };
        for (const Mesh::Corners& face : mesh.faces) {
            const Vec3d a = scaled(mesh.vertices[face[0]]);
            const Vec3d b = scaled(mesh.vertices[face[1]]) - a;
            const Vec3d c = scaled(mesh.vertices[face[2]]) - a;
            const double size = std::max(max_component(absolute(b)), max_component(absolute(c)));
            Vec3d normal(0.0);
            double twice_area = 0;
            if (size > 0) {
                normal = cross(b / size, c / size);
                twice_area = length(normal) * size * size;
                const double longest = max_component(absolute(normal));
                if (longest > 0) normal = normalize(normal / longest);
            }
            normals_.push_back(normal);
            areas_.push_back(twice_area);
        }
        begins_.assign(mesh.vertices.size() + 1, 0);
        for (const Mesh::Corners& face : mesh.faces)
            for (const std::uint32_t vertex : face) ++begins_[vertex + std::size_t{1}];
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        corners_.resize(mesh.faces.size() * 3);
        std::vector<std::uint64_t> next(begins_.begin(), begins_.end() - 1);
        for (std::size_t f = 0; f < mesh.faces.size(); ++f)
            for (std::uint32_t k = 0; k < 3; ++k)
                corners_[next[mesh.faces[f][k]]++] = {static_cast<std::uint32_t>(f), k};
    }

    struct Corner {
        std::uint32_t face, corner;
    };
    std::span<const Corner> at(std::size_t vertex) const {
        return std::span(corners_).subspan(begins_[vertex], begins_[vertex + 1] - begins_[vertex]);
    }

    /// Calls `visit(i, j, other)` for each edge of exactly two faces from the vertex to `other`;
    /// the faces' corners are at(vertex)[i] and [j].
    template <class Visit>
    void for_each_edge(std::size_t vertex, Visit visit) {
        const auto here = at(vertex);
        ends_.clear();
        for (std::uint32_t i = 0; i < here.size(); ++i) {
            const Mesh::Corners& face = mesh_.faces[here[i].face];
            ends_.push_back({face[(here[i].corner + 1) % 3], i});
            ends_.push_back({face[(here[i].corner + 2) % 3], i});
        }
        std::sort(ends_.begin(), ends_.end());
        for (auto end = ends_.begin(); end != ends_.end();) {
            const auto next = std::find_if(end, ends_.end(),
                                           [&](const auto& e) { return e.first != end->first; });
            if (next - end == 2) visit(end[0].second, end[1].second, end->first);
            end = next;
        }
    }

    bool is_sharp(std::uint32_t face, std::uint32_t other) const {
        return dot(normals_[face], normals_[other]) < least_cosine_;
    }
    Vec3d weighted(std::uint32_t face) const { return normals_[face] * areas_[face]; }
    const Vec3d& normal(std::uint32_t face) const { return normals_[face]; }

  private:
    const Mesh& mesh_;
    double least_cosine_ = 0;
    std::vector<Vec3d> normals_;  ///< unit
    std::vector<double> areas_;
    std::vector<std::uint64_t> begins_;  ///< into corners_, by vertex
    std::vector<Corner> corners_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;
};

}  // namespace

Mesh with_sharp_edges(const Mesh& mesh, double degrees) {
    Neighbours neighbours(mesh, degrees);
    Mesh result = mesh;
    result.normals.clear();
    result.normal_faces.assign(mesh.faces.size(), {none, none, none});
    // for each corner at the vertex, the first one connected to it
    std::vector<std::uint32_t> group;
    std::vector<std::uint32_t> normal_of;
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        const auto here = neighbours.at(vertex);
        group.resize(here.size());
        std::iota(group.begin(), group.end(), 0u);
        const auto root = [&](std::uint32_t i) {
            while (group[i] != i) i = group[i] = group[group[i]];
            return i;
        };
        neighbours.for_each_edge(vertex, [&](std::uint32_t i, std::uint32_t j, std::uint32_t) {
            if (neighbours.is_sharp(here[i].face, here[j].face)) return;
            const auto [low, high] = std::minmax({root(i), root(j)});
            group[high] = low;
        });
        normal_of.assign(here.size(), none);
        for (std::uint32_t i = 0; i < here.size(); ++i) {
            std::uint32_t& normal = normal_of[root(i)];
            if (normal == none) {
                normal = static_cast<std::uint32_t>(result.normals.size());
                result.normals.emplace_back(0.0);
            }
            result.normals[normal] += neighbours.weighted(here[i].face);
            result.normal_faces[here[i].face][here[i].corner] = normal;
        }
    }
    for (Vec3d& normal : result.normals) {
        const double size = max_component(absolute(normal));
        if (size > 0) normal = normalize(normal / size);
    }
    return result;
}

std::size_t count_sharp_edges(const Mesh& mesh, double degrees) {
    Neighbours neighbours(mesh, degrees);
    std::size_t count = 0;
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        const auto here = neighbours.at(vertex);
        neighbours.for_each_edge(
            vertex, [&](std::uint32_t i, std::uint32_t j, std::uint32_t other) {
                if (other > vertex && neighbours.is_sharp(here[i].face, here[j].face)) ++count;
            });
    }
    return count;
}

}  // namespace lancer
