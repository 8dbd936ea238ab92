#include "tracer/tessellation/triangulation.h"

#include <algorithm>
#include <optional>

namespace lancer::splines {
namespace {

/// The chains of vertices of a polygon: whether each, closed by the line between its ends, can be
/// triangulated.
class Chains {
  public:
    Chains(const NearPatch& patch, const std::vector<FootPoint>& vertices,
           const std::vector<std::uint32_t>& polygon)
        : patch_(patch),
          vertices_(vertices),
          polygon_(polygon),
          apex_(polygon.size() * polygon.size()) {}

    bool holds(std::size_t from, std::size_t to) {
        if (to - from < 2) return true;
        std::optional<std::size_t>& apex = apex_[from * polygon_.size() + to];
        if (!apex) apex = find_apex(from, to);
        return *apex != none;
    }

    /// Appends the faces of a chain for which holds() was true.
    void collect(std::size_t from, std::size_t to, std::vector<Face>& faces) const {
        if (to - from < 2) return;
        const std::size_t apex = *apex_[from * polygon_.size() + to];
        faces.push_back({polygon_[from], polygon_[apex], polygon_[to]});
        collect(from, apex, faces);
        collect(apex, to, faces);
    }

  private:
    static constexpr std::size_t none = 0;  ///< index 0 is never an inner vertex of a chain

    std::size_t find_apex(std::size_t from, std::size_t to) {
        // From the middle outwards, which avoids thin triangles.
        const std::size_t middle = (from + to) / 2;
        for (std::size_t away = 0; away < to - from; ++away) {
            for (const std::size_t k : {middle - away, middle + away}) {
                if (k > from && k < to && accepts({polygon_[from], polygon_[k], polygon_[to]}) &&
                    holds(from, k) && holds(k, to))
                    return k;
                if (away == 0) break;
            }
        }
        return none;
    }

    bool accepts(const Face& f) const {
        const std::array t{vertices_[f[0]], vertices_[f[1]], vertices_[f[2]]};
        const Vec2d e = t[1].at - t[0].at;
        const Vec2d g = t[2].at - t[0].at;
        return e.x * g.y > e.y * g.x && patch_.holds(t);
    }

    const NearPatch& patch_;
    const std::vector<FootPoint>& vertices_;
    const std::vector<std::uint32_t>& polygon_;
    std::vector<std::optional<std::size_t>> apex_;
};

/// Removes vertices from a triangulation; it keeps the faces at each vertex.
class Thinning {
  public:
    Thinning(const NearPatch& patch, Triangulation& mesh)
        : patch_(patch), mesh_(mesh), faces_at_(mesh.vertices.size()) {
        for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
            for (const auto v : mesh.faces[f]) faces_at_[v].push_back(f);
        }
    }

    void run(std::size_t first) {
        // Whether the faces around the vertex have changed since it was tried last.
        std::vector<bool> is_new(mesh_.vertices.size(), true);
        for (bool changed = true; changed;) {
            changed = false;
            for (auto v = static_cast<std::uint32_t>(mesh_.vertices.size()); v-- > first;) {
                if (!is_new[v] || faces_at_[v].empty()) continue;
                is_new[v] = false;
                const std::vector<std::uint32_t> around = neighbours(v);
                std::vector<Face> filling;
                if (!triangulate_polygon(patch_, mesh_.vertices, around, filling)) continue;
                replace(v, filling);
                for (const auto w : around) is_new[w] = true;
                changed = true;
            }
        }
        drop_unused();
    }

  private:
    static constexpr Face gone{0, 0, 0};

    /// The other two corners of a face, in order after v.
    std::pair<std::uint32_t, std::uint32_t> others(std::uint32_t face, std::uint32_t v) const {
        const Face& f = mesh_.faces[face];
        return f[0] == v   ? std::pair(f[1], f[2])
               : f[1] == v ? std::pair(f[2], f[0])
                           : std::pair(f[0], f[1]);
    }

    /// The neighbours of an inner vertex, counter-clockwise.
    std::vector<std::uint32_t> neighbours(std::uint32_t v) const {
        const auto& faces = faces_at_[v];
        std::vector<std::uint32_t> around;
        for (auto at = others(faces.front(), v).first; around.size() < faces.size();) {
            around.push_back(at);
            const auto next = std::ranges::find_if(
                faces, [&](std::uint32_t f) { return others(f, v).first == at; });
            at = others(*next, v).second;
        }
        return around;
    }

    /// Removes v. The filling has two faces fewer than v had.
    void replace(std::uint32_t v, const std::vector<Face>& filling) {
        const std::vector<std::uint32_t> old = faces_at_[v];
        for (const auto f : old) {
            for (const auto w : mesh_.faces[f]) std::erase(faces_at_[w], f);
            mesh_.faces[f] = gone;
        }
        for (std::size_t i = 0; i < filling.size(); ++i) {
            mesh_.faces[old[i]] = filling[i];
            for (const auto w : filling[i]) faces_at_[w].push_back(old[i]);
        }
    }

    void drop_unused() {
        std::erase(mesh_.faces, gone);
        std::vector<std::uint32_t> place(mesh_.vertices.size());
        std::uint32_t kept = 0;
        for (std::size_t v = 0; v < place.size(); ++v) {
            place[v] = kept;
            if (!faces_at_[v].empty()) mesh_.vertices[kept++] = mesh_.vertices[v];
        }
        mesh_.vertices.resize(kept);
        for (Face& f : mesh_.faces) f = {place[f[0]], place[f[1]], place[f[2]]};
    }

    const NearPatch& patch_;
    Triangulation& mesh_;
    std::vector<std::vector<std::uint32_t>> faces_at_;
};

}  // namespace

bool triangulate_polygon(const NearPatch& patch, const std::vector<FootPoint>& vertices,
                         const std::vector<std::uint32_t>& polygon, std::vector<Face>& faces) {
    Chains chains(patch, vertices, polygon);
    if (!chains.holds(0, polygon.size() - 1)) return false;
    chains.collect(0, polygon.size() - 1, faces);
    return true;
}

void remove_vertices(const NearPatch& patch, Triangulation& mesh, std::size_t first) {
    Thinning(patch, mesh).run(first);
}

}  // namespace lancer::splines
