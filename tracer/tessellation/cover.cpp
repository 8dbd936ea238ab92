#include "tracer/tessellation/cover.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tracer/tessellation/borders.h"
#include "tracer/tessellation/grid_size.h"

namespace lancer::splines {
namespace {

/// How often a strip between a border and the grid is halved before a finer grid is tried.
constexpr int ring_limit = 6;
/// The longest border for which a triangulation without inner vertices is tried.
constexpr std::size_t polygon_limit = 40;
/// In grids of fewer cells, vertices are removed everywhere, because most of the grid is rim. In
/// larger grids only vertices that were added at the rim are removed, and only if they add more
/// than rim_share to the grid's faces.
constexpr std::size_t few_cells = 200;
constexpr double rim_share = 0.25;

using Index = std::uint32_t;

/// A closed row of vertices around the patch, as four sides, counter-clockwise in (u, v) from the
/// corner (0, 0). Each side contains both its ends.
using Ring = std::array<std::vector<Index>, 4>;

class Cover {
  public:
    Cover(const NearPatch& patch, const std::array<int, 4>& border)
        : patch_(patch), border_(border) {}

    Triangulation build() {
        const Ring outer = border_ring();
        const std::size_t rim = mesh_.vertices.size();
        Grid n = proved_grid(patch_);
        if (std::min(n.u, n.v) <= 2 && rim <= polygon_limit) {
            std::vector<Index> polygon(rim);
            std::iota(polygon.begin(), polygon.end(), 0u);
            if (triangulate_polygon(patch_, mesh_.vertices, polygon, mesh_.faces))
                return std::move(mesh_);
        }
        if (std::min(n.u, n.v) < 2) n = proved_grid(patch_, 2, 2);
        while (!join(outer, 0.0, grid(n), 1.0, n, 0)) {
            // First more vertices in the rings between border and grid; finally a finer grid.
            mesh_.vertices.resize(rim);
            mesh_.faces.clear();
            ring_density_ *= 1.5;
            if (ring_density_ > 4) n = proved_grid(patch_, n.u + n.u / 4 + 1, n.v + n.v / 4 + 1);
        }
        thin_out(n, rim);
        return std::move(mesh_);
    }

  private:
    Index add(const FootPoint& vertex) {
        mesh_.vertices.push_back(vertex);
        return static_cast<Index>(mesh_.vertices.size() - 1);
    }
    void thin_out(const Grid& n, std::size_t rim) {
        const auto u = static_cast<std::size_t>(n.u);
        const auto v = static_cast<std::size_t>(n.v);
        const std::size_t inside = (u - 1) * (v - 1);
        if (u * v < few_cells) {
            remove_vertices(patch_, mesh_, rim);
        } else if (static_cast<double>(mesh_.faces.size()) >
                   (1 + rim_share) * 2 * static_cast<double>(u * v)) {
            remove_vertices(patch_, mesh_, rim + inside);
        }
    }

    Index add_inner(double u, double v) { return add(FootPoint::on(patch_.points(), {u, v})); }

    Ring border_ring() {
        Ring ring;
        const auto curves = border_curves(patch_.points());
        constexpr std::array<std::array<int, 2>, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        for (std::size_t k = 0; k < 4; ++k) {
            const BorderCurve& c = curves[k];
            const auto& [u0, v0] = corner[k];
            const auto& [u1, v1] = corner[(k + 1) % 4];
            for (int i = 0; i < border_[k]; ++i) {
                const Place<double> at(i, border_[k]);
                // Computed from the border curve, not from the patch: for the neighbour it must
                // have the same bits.
                const Vec3d point = i == 0 ? c[0] : cubic(c[0], c[1], c[2], c[3], at).first;
                const Vec2d uv(u0 * at.rest + u1 * at.s, v0 * at.rest + v1 * at.s);
                ring[k].push_back(add({uv, point, Vec3d(0)}));
            }
        }
        close(ring);
        return ring;
    }

    static void close(Ring& ring) {
        for (std::size_t k = 0; k < 4; ++k) ring[k].push_back(ring[(k + 1) % 4].front());
    }

    /// Adds the vertices and faces of the grid; returns the ring around them.
    Ring grid(const Grid& n) {
        const auto columns = static_cast<Index>(n.u - 1);
        const auto rows = static_cast<Index>(n.v - 1);
        const auto first = static_cast<Index>(mesh_.vertices.size());
        for (int j = 1; j < n.v; ++j) {
            for (int i = 1; i < n.u; ++i)
                add_inner(static_cast<double>(i) / n.u, static_cast<double>(j) / n.v);
        }
        const auto at = [&](Index i, Index j) { return first + j * columns + i; };
        for (Index j = 0; j + 1 < rows; ++j) {
            for (Index i = 0; i + 1 < columns; ++i) {
                const bool rising = n.rising[(j + 1) * static_cast<std::size_t>(n.u) + i + 1] != 0;
                mesh_.faces.push_back({at(i, j), at(i + 1, j), at(rising ? i + 1 : i, j + 1)});
                mesh_.faces.push_back({at(rising ? i : i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
        Ring ring;
        for (Index i = 0; i + 1 < columns; ++i) {
            ring[0].push_back(at(i, 0));
            ring[2].push_back(at(columns - 1 - i, rows - 1));
        }
        for (Index j = 0; j + 1 < rows; ++j) {
            ring[1].push_back(at(columns - 1, j));
            ring[3].push_back(at(0, rows - 1 - j));
        }
        // The corners, even where a side has no other vertex.
        ring[0].push_back(at(columns - 1, 0));
        ring[1].push_back(at(columns - 1, rows - 1));
        ring[2].push_back(at(0, rows - 1));
        ring[3].push_back(at(0, 0));
        return ring;
    }

    /// Fills the space between two rings. If the triangles of a single strip are not all proved,
    /// inserts further rings between them; this happens near a border that is much straighter than
    /// the inside. Returns false if it fails. A ring at f lies at u = f/n, v = f/n from the border,
    /// so 0 is the border and 1 the grid.
    bool join(const Ring& outer, double f_outer, const Ring& inner, double f_inner, const Grid& n,
              int depth) {
        const std::size_t faces = mesh_.faces.size();
        bool kept = true;
        for (std::size_t k = 0; k < 4 && kept; ++k) kept = strip(outer[k], inner[k], k);
        if (kept) return true;
        mesh_.faces.resize(faces);
        if (depth == ring_limit) return false;
        const double f = f_outer == 0 ? f_inner / 4 : std::sqrt(f_outer * f_inner);
        Ring middle;
        const double u0 = f / n.u;
        const double v0 = f / n.v;
        const std::array<Vec2d, 4> corner{
            Vec2d{u0, v0}, {1 - u0, v0}, {1 - u0, 1 - v0}, {u0, 1 - v0}};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto most = std::max(outer[k].size(), inner[k].size()) - 1;
            const int count =
                static_cast<int>(std::ceil(ring_density_ * static_cast<double>(most)));
            for (int i = 0; i < count; ++i) {
                const Place<double> at(i, count);
                const Vec2d uv = corner[k] * at.rest + corner[(k + 1) % 4] * at.s;
                middle[k].push_back(add_inner(uv.x, uv.y));
            }
        }
        close(middle);
        return join(outer, f_outer, middle, f, n, depth + 1) &&
               join(middle, f, inner, f_inner, n, depth + 1);
    }

    /// Adds the triangles between two rows of one side; false if one of them is not proved.
    bool strip(const std::vector<Index>& outer, const std::vector<Index>& inner, std::size_t side) {
        const auto along = [&](Index vertex) {
            const Vec2d& c = mesh_.vertices[vertex].at;
            return side == 0 ? c.x : side == 1 ? c.y : side == 2 ? 1 - c.x : 1 - c.y;
        };
        const auto middle = [&](const std::vector<Index>& row, std::size_t i) {
            return along(row[i]) + along(row[i + 1]);
        };
        for (std::size_t i = 0, j = 0; i + 1 < outer.size() || j + 1 < inner.size();) {
            // The row that lags behind advances, if that gives a proved triangle.
            bool outer_next = j + 1 == inner.size() ||
                              (i + 1 < outer.size() && middle(outer, i) <= middle(inner, j));
            const auto next = [&](bool by_outer) {
                return by_outer ? Face{outer[i], outer[i + 1], inner[j]}
                                : Face{outer[i], inner[j + 1], inner[j]};
            };
            if (!keeps(next(outer_next))) {
                const bool other = outer_next ? j + 1 < inner.size() : i + 1 < outer.size();
                if (!other || !keeps(next(!outer_next))) return false;
                outer_next = !outer_next;
            }
            mesh_.faces.push_back(next(outer_next));
            (outer_next ? i : j) += 1;
        }
        return true;
    }

    bool keeps(const Face& f) const {
        return patch_.holds({mesh_.vertices[f[0]], mesh_.vertices[f[1]], mesh_.vertices[f[2]]});
    }

    const NearPatch& patch_;
    std::array<int, 4> border_;
    Triangulation mesh_;
    double ring_density_ = 1;
};

}  // namespace

Triangulation cover(const NearPatch& patch, const std::array<int, 4>& border) {
    return Cover(patch, border).build();
}

}  // namespace lancer::splines
