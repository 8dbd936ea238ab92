#include "tracer/splines/tessellate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "model/patch_net.h"
#include "model/splines.h"
#include "tracer/splines/bicubic.h"
#include "tracer/splines/certificate.h"
#include "tracer/splines/grid_size.h"

namespace lancer::splines {
namespace {

/// A border gets this share of the tolerance: the strips beside it then have some to spend.
constexpr double border_share = 0.75;
/// Times that a strip between a border and the grid is halved before a finer grid is tried.
constexpr int ring_limit = 6;

struct Corner {
    double u;
    double v;
    std::uint32_t vertex;
};

/// A closed row of vertices around the patch, in four sides, counter-clockwise in (u, v) from the
/// corner (0, 0). A side lists both its ends.
using Ring = std::array<std::vector<Corner>, 4>;

/// Where a net's patch lies, for its texture coordinates.
struct NetPlace {
    std::size_t row, column, rows, columns;
};

/// Builds the triangles of one Bezier patch.
class PatchMesher {
  public:
    PatchMesher(const Bicubic<double>& points, double tolerance, const std::array<int, 4>& border,
                const NetPlace& place, Mesh& mesh)
        : p_(points),
          curvature_(points),
          tolerance_(tolerance),
          border_(border),
          place_(place),
          mesh_(mesh) {}

    void build() {
        const Ring outer = border_ring();
        if (border_ == std::array{1, 1, 1, 1}) {
            const std::array<Corner, 4> c{outer[0][0], outer[1][0], outer[2][0], outer[3][0]};
            for (const std::size_t k : {0u, 1u}) {
                const std::array t{std::array{c[k], c[k + 1], c[(k + 2) % 4]},
                                   std::array{c[k], c[(k + 2) % 4], c[(k + 3) % 4]}};
                if (!is_near(t[0]) || !is_near(t[1])) continue;
                for (const auto& [p, q, r] : t) emit(p, q, r);
                return;
            }
        }
        const std::size_t vertices = mesh_.vertices.size();
        const std::size_t faces = mesh_.faces.size();
        Grid n = proved_grid(p_, curvature_, tolerance_);
        while (!join(outer, 0.0, grid(n), 1.0, n, 0)) {
            // Rings of more vertices between border and grid; in the end a finer grid.
            mesh_.vertices.resize(vertices);
            mesh_.normals.resize(vertices);
            mesh_.uvs.resize(vertices);
            mesh_.faces.resize(faces);
            ring_density_ *= 1.5;
            if (ring_density_ > 4) n = finer_grid(p_, curvature_, tolerance_, n);
        }
    }

  private:
    std::uint32_t add(const Vec3d& point, double u, double v) {
        mesh_.vertices.push_back(point);
        mesh_.normals.push_back(normal(p_, u, v));
        mesh_.uvs.emplace_back(
            (static_cast<double>(place_.column) + u) / static_cast<double>(place_.columns),
            (static_cast<double>(place_.row) + v) / static_cast<double>(place_.rows));
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }
    std::uint32_t add_inner(double u, double v) {
        return add(sample(p_, Place<double>(u), Place<double>(v)).point, u, v);
    }

    /// A triangle, unless two of its corners are the same point (at a pole).
    void emit(const Corner& a, const Corner& b, const Corner& c) {
        const Vec3d& pa = mesh_.vertices[a.vertex];
        const Vec3d& pb = mesh_.vertices[b.vertex];
        const Vec3d& pc = mesh_.vertices[c.vertex];
        if (pa == pb || pb == pc || pc == pa) return;
        mesh_.faces.push_back({a.vertex, b.vertex, c.vertex});
    }

    Ring border_ring() {
        // Control points of the four sides, each in its direction of travel.
        constexpr std::array<std::array<std::size_t, 4>, 4> side{
            {{0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}}};
        Ring ring;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto& c = side[k];
            const int n = border_[k];
            for (int i = 0; i < n; ++i) {
                const Place<double> at(i, n);
                const Vec3d point =
                    i == 0 ? p_[c[0]] : cubic(p_[c[0]], p_[c[1]], p_[c[2]], p_[c[3]], at).first;
                const double u = k == 0 ? at.s : k == 1 ? 1 : k == 2 ? at.rest : 0;
                const double v = k == 0 ? 0 : k == 1 ? at.s : k == 2 ? 1 : at.rest;
                ring[k].push_back({u, v, add(point, u, v)});
            }
        }
        close(ring);
        return ring;
    }

    static void close(Ring& ring) {
        for (std::size_t k = 0; k < 4; ++k) ring[k].push_back(ring[(k + 1) % 4].front());
    }

    /// The inside of the grid; returns the ring around it.
    Ring grid(const Grid& n) {
        const auto columns = static_cast<std::size_t>(n.u - 1);
        const auto rows = static_cast<std::size_t>(n.v - 1);
        std::vector<Corner> at;
        at.reserve(rows * columns);
        for (int j = 1; j < n.v; ++j) {
            for (int i = 1; i < n.u; ++i) {
                const double u = static_cast<double>(i) / n.u;
                const double v = static_cast<double>(j) / n.v;
                at.push_back({u, v, add_inner(u, v)});
            }
        }
        for (std::size_t j = 0; j + 1 < rows; ++j) {
            for (std::size_t i = 0; i + 1 < columns; ++i) {
                const Corner* c = &at[j * columns + i];
                const bool rising = n.rising[(j + 1) * static_cast<std::size_t>(n.u) + i + 1] != 0;
                emit(c[0], c[1], rising ? c[columns + 1] : c[columns]);
                emit(rising ? c[0] : c[1], c[columns + 1], c[columns]);
            }
        }
        Ring ring;
        for (std::size_t i = 0; i + 1 < columns; ++i) {
            ring[0].push_back(at[i]);
            ring[2].push_back(at[rows * columns - 1 - i]);
        }
        for (std::size_t j = 0; j + 1 < rows; ++j) {
            ring[1].push_back(at[(j + 1) * columns - 1]);
            ring[3].push_back(at[(rows - 1 - j) * columns]);
        }
        // The corners, also where a side has no other vertex.
        ring[0].push_back(at[columns - 1]);
        ring[1].push_back(at[rows * columns - 1]);
        ring[2].push_back(at[(rows - 1) * columns]);
        ring[3].push_back(at[0]);
        return ring;
    }

    /// Fills the space between two rings, or tells that it cannot: with further rings where one
    /// strip would break the promise: near a border that is much straighter than the inside, step
    /// by step. A ring at f lies at u = f/n, v = f/n from the border, so 0 is the border and 1 the
    /// grid.
    bool join(const Ring& outer, double f_outer, const Ring& inner, double f_inner, const Grid& n,
              int depth) {
        std::vector<std::array<Corner, 3>> triangles;
        bool kept = true;
        for (std::size_t k = 0; k < 4; ++k) {
            kept = kept && strip(outer[k], inner[k], k, f_outer == 0, triangles);
        }
        if (kept) {
            for (const auto& t : triangles) emit(t[0], t[1], t[2]);
            return true;
        }
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
                middle[k].push_back({uv.x, uv.y, add_inner(uv.x, uv.y)});
            }
        }
        close(middle);
        return join(outer, f_outer, middle, f, n, depth + 1) &&
               join(middle, f, inner, f_inner, n, depth + 1);
    }

    /// The triangles between two rows of one side; false when one breaks the promise.
    bool strip(const std::vector<Corner>& outer, const std::vector<Corner>& inner, std::size_t side,
               bool at_border, std::vector<std::array<Corner, 3>>& triangles) {
        const auto along = [&](const Corner& c) {
            return side == 0 ? c.u : side == 1 ? c.v : side == 2 ? 1 - c.u : 1 - c.v;
        };
        const auto middle = [&](const std::vector<Corner>& row, std::size_t i) {
            return along(row[i]) + along(row[i + 1]);
        };
        const auto keeps = [&](const std::array<Corner, 3>& t, std::size_t i) {
            return is_near(t) ||
                   (at_border &&
                    ((i + 1 < outer.size() && is_at_chord(t, outer[i], outer[i + 1])) ||
                     (i > 0 && is_at_chord(t, outer[i - 1], outer[i]))));
        };
        for (std::size_t i = 0, j = 0; i + 1 < outer.size() || j + 1 < inner.size();) {
            // Which row goes on: the one behind, if that makes a triangle that keeps the promise.
            bool outer_next = j + 1 == inner.size() ||
                              (i + 1 < outer.size() && middle(outer, i) <= middle(inner, j));
            const auto next = [&](bool by_outer) {
                return by_outer ? std::array{outer[i], outer[i + 1], inner[j]}
                                : std::array{outer[i], inner[j + 1], inner[j]};
            };
            if (!keeps(next(outer_next), i)) {
                const bool other = outer_next ? j + 1 < inner.size() : i + 1 < outer.size();
                if (!other || !keeps(next(!outer_next), i)) return false;
                outer_next = !outer_next;
            }
            triangles.push_back(next(outer_next));
            (outer_next ? i : j) += 1;
        }
        return true;
    }

    /// Whether the triangle lies so near a chord of the border, which has its own promise, that
    /// nothing else is to be proved.
    bool is_at_chord(const std::array<Corner, 3>& t, const Corner& from, const Corner& to) const {
        const Vec3d& a = mesh_.vertices[from.vertex];
        const Vec3d chord = mesh_.vertices[to.vertex] - a;
        const double squared = length_squared(chord);
        double farthest = 0;
        for (const Corner& c : t) {
            const Vec3d d = mesh_.vertices[c.vertex] - a;
            const double s = squared > 0 ? std::clamp(dot(d, chord) / squared, 0.0, 1.0) : 0.0;
            farthest = std::max(farthest, length(d - s * chord));
        }
        return farthest <= (1 - border_share) * tolerance_;
    }

    /// Whether the triangle is proved to keep the promise.
    bool is_near(const std::array<Corner, 3>& t) const {
        return splines::is_near(
            p_, curvature_,
            chord_triangle(p_, {Vec2d(t[0].u, t[0].v), {t[1].u, t[1].v}, {t[2].u, t[2].v}}),
            tolerance_, 3);
    }

    Bicubic<double> p_;
    Curvature curvature_;
    double tolerance_;
    std::array<int, 4> border_;
    NetPlace place_;
    Mesh& mesh_;
    double ring_density_ = 1;
};

/// A net in units of its size, in which squares of lengths stay in range.
struct ScaledNet {
    BezierNet net;
    int exponent;                     ///< the net's own points are these times 2^exponent
    std::optional<double> tolerance;  ///< as given
    double inside;                    ///< the tolerance that holds

    ScaledNet(const Patch& patch, std::optional<double> given) : net(bezier_net(patch)) {
        const double size = hull_diagonal(patch);
        exponent = std::ilogb(size);
        for (Vec3d& p : net.points) p = scaled(p, -exponent);
        if (given) tolerance = std::ldexp(*given, -exponent);
        inside = tolerance.value_or(std::ldexp(size, -exponent) / 2000);
    }

    static Vec3d scaled(const Vec3d& p, int exponent) {
        return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    }

    /// Steps along each side.
    std::array<int, 4> border(const BezierPatch& p, const BorderTolerances* borders) const {
        std::array<int, 4> steps{};
        const auto curves = border_curves(p);
        for (std::size_t k = 0; k < 4; ++k) {
            const BorderCurve& c = curves[k];
            double within = border_tolerance(c, tolerance);
            if (borders != nullptr) {
                const auto shared = borders->at({scaled(c[0], exponent), scaled(c[1], exponent),
                                                 scaled(c[2], exponent), scaled(c[3], exponent)});
                if (shared) within = std::min(within, std::ldexp(*shared, -exponent));
            }
            const bool is_point = c[0] == c[1] && c[1] == c[2] && c[2] == c[3];
            steps[k] = is_point ? 1 : curve_steps(c[0], c[1], c[2], c[3], border_share * within);
        }
        return steps;
    }
};

}  // namespace

bool is_within_limit(const Patch& patch, std::optional<double> tolerance) {
    if (is_single_point(patch.control)) return true;
    const ScaledNet scaled(patch, tolerance);
    double triangles = 0;
    for (std::size_t i = 0; i < scaled.net.rows; ++i) {
        for (std::size_t j = 0; j < scaled.net.columns; ++j) {
            const BezierPatch p = scaled.net.patch(i, j);
            // As if the whole patch were as curved as its worst part; looked at closely when in
            // doubt.
            double cells = chord_error(Curvature(p).largest_lengths(), 1, 1) / scaled.inside;
            if (!(2 * cells < 1e6)) {
                const Grid n = likely_grid(p, scaled.inside);
                cells = static_cast<double>(n.u) * n.v;
            }
            triangles += 2 * cells;
            for (const BorderCurve& c : border_curves(p)) {
                const double within = border_tolerance(c, scaled.tolerance);
                if (within > 0) triangles += likely_curve_steps(c[0], c[1], c[2], c[3], within);
            }
        }
    }
    return triangles <= static_cast<double>(triangle_limit);
}

std::optional<Mesh> tessellate(const Patch& patch, std::optional<double> tolerance,
                               const BorderTolerances* borders) {
    if (is_single_point(patch.control)) return Mesh{};
    if (!is_within_limit(patch, tolerance)) return std::nullopt;
    const ScaledNet scaled(patch, tolerance);
    const BezierNet& net = scaled.net;
    Mesh mesh;
    for (std::size_t i = 0; i < net.rows; ++i) {
        for (std::size_t j = 0; j < net.columns; ++j) {
            const BezierPatch p = net.patch(i, j);
            PatchMesher(p, scaled.inside, scaled.border(p, borders), {i, j, net.rows, net.columns},
                        mesh)
                .build();
        }
    }
    for (Vec3d& p : mesh.vertices) p = ScaledNet::scaled(p, scaled.exponent);
    return mesh;
}

}  // namespace lancer::splines
