#include "tracer/splines/tessellate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "model/patch_net.h"
#include "model/splines.h"
#include "tracer/splines/bicubic.h"
#include "tracer/splines/grid_size.h"

namespace lancer::splines {
namespace {

/// A border gets this share of the tolerance: the strips beside it then have some to spend.
constexpr double border_share = 0.75;
/// Rings between a border and the grid before the attempt is given up; a dozen is a lot.
constexpr int ring_limit = 40;

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
        if (border_ == std::array{1, 1, 1, 1} &&
            chord_error(curvature_.over(0, 1, 0, 1), 1, 1) <= tolerance_) {
            emit(outer[0][0], outer[0][1], outer[1][1]);
            emit(outer[0][0], outer[1][1], outer[2][1]);
            return;
        }
        GridSize n = grid_size(curvature_, tolerance_);
        n = {std::max(n.u, 2), std::max(n.v, 2)};
        join(outer, 0.0, grid(n), 1.0, n, 0);
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
    Ring grid(const GridSize& n) {
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
                emit(c[0], c[1], c[columns + 1]);
                emit(c[0], c[columns + 1], c[columns]);
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

    /// Fills the space between two rings, with further rings where one strip would break the
    /// promise: near a border that is much straighter than the inside, step by step. A ring at f
    /// lies at u = f/n, v = f/n from the border, so 0 is the border and 1 the grid.
    void join(const Ring& outer, double f_outer, const Ring& inner, double f_inner,
              const GridSize& n, int depth) {
        std::vector<std::array<Corner, 3>> triangles;
        bool kept = true;
        for (std::size_t k = 0; k < 4; ++k) {
            kept = strip(outer[k], inner[k], k, f_inner, n, triangles) && kept;
        }
        if (kept || depth > ring_limit) {
            for (const auto& t : triangles) emit(t[0], t[1], t[2]);
            return;
        }
        const double f = f_outer == 0 ? f_inner / 4 : std::sqrt(f_outer * f_inner);
        Ring middle;
        const double u0 = f / n.u;
        const double v0 = f / n.v;
        const std::array<Vec2d, 4> corner{
            Vec2d{u0, v0}, {1 - u0, v0}, {1 - u0, 1 - v0}, {u0, 1 - v0}};
        for (std::size_t k = 0; k < 4; ++k) {
            const double outside = static_cast<double>(outer[k].size() - 1);
            const double inside = std::max(1.0, static_cast<double>(inner[k].size() - 1));
            const int count = static_cast<int>(std::ceil(std::sqrt(outside * inside)));
            for (int i = 0; i < count; ++i) {
                const Place<double> at(i, count);
                const Vec2d uv = corner[k] * at.rest + corner[(k + 1) % 4] * at.s;
                middle[k].push_back({uv.x, uv.y, add_inner(uv.x, uv.y)});
            }
        }
        close(middle);
        join(outer, f_outer, middle, f, n, depth + 1);
        join(middle, f, inner, f_inner, n, depth + 1);
    }

    /// The triangles between two rows of one side; false when one breaks the promise.
    bool strip(const std::vector<Corner>& outer, const std::vector<Corner>& inner, std::size_t side,
               double f_inner, const GridSize& n, std::vector<std::array<Corner, 3>>& triangles) {
        const StripBounds bounds(curvature_, side, side % 2 == 0 ? f_inner / n.v : f_inner / n.u);
        const auto along = [&](const Corner& c) {
            return side == 0 ? c.u : side == 1 ? c.v : side == 2 ? 1 - c.u : 1 - c.v;
        };
        const auto middle = [&](const std::vector<Corner>& row, std::size_t i) {
            return along(row[i]) + along(row[i + 1]);
        };
        bool kept = true;
        std::size_t i = 0;
        std::size_t j = 0;
        while (i + 1 < outer.size() || j + 1 < inner.size()) {
            const bool outer_next = j + 1 == inner.size() ||
                                    (i + 1 < outer.size() && middle(outer, i) <= middle(inner, j));
            const std::array<Corner, 3> t = outer_next
                                                ? std::array{outer[i], outer[i + 1], inner[j]}
                                                : std::array{outer[i], inner[j + 1], inner[j]};
            (outer_next ? i : j) += 1;
            kept = kept && bounds.hold(t, along, tolerance_);
            triangles.push_back(t);
        }
        return kept;
    }

    /// Second derivatives along a strip beside one side, in four stretches.
    struct StripBounds {
        std::array<SecondDerivatives, 4> stretch;

        StripBounds(const Curvature& curvature, std::size_t side, double width) {
            for (std::size_t k = 0; k < 4; ++k) {
                double a = static_cast<double>(k) / 4;
                double b = static_cast<double>(k + 1) / 4;
                if (side >= 2) std::tie(a, b) = std::pair{1 - b, 1 - a};
                const double low = side == 1 || side == 2 ? 1 - width : 0;
                const double high = side == 1 || side == 2 ? 1 : width;
                stretch[k] = side % 2 == 0 ? curvature.over(a, b, low, high)
                                           : curvature.over(low, high, a, b);
            }
        }

        template <class Along>
        bool hold(const std::array<Corner, 3>& t, const Along& along, double tolerance) const {
            const auto [u0, u1] = std::minmax({t[0].u, t[1].u, t[2].u});
            const auto [v0, v1] = std::minmax({t[0].v, t[1].v, t[2].v});
            const auto [a0, a1] = std::minmax({along(t[0]), along(t[1]), along(t[2])});
            SecondDerivatives d;
            for (std::size_t k = 0; k < 4; ++k) {
                if (a1 < static_cast<double>(k) / 4 || a0 > static_cast<double>(k + 1) / 4)
                    continue;
                d = {std::max(d.uu, stretch[k].uu), std::max(d.uv, stretch[k].uv),
                     std::max(d.vv, stretch[k].vv)};
            }
            return chord_error(d, u1 - u0, v1 - v0) <= tolerance;
        }
    };

    Bicubic<double> p_;
    Curvature curvature_;
    double tolerance_;
    std::array<int, 4> border_;
    NetPlace place_;
    Mesh& mesh_;
};

/// Steps for a border curve: by the given tolerance, or by its own size.
int border_steps(const Vec3d& p0, const Vec3d& p1, const Vec3d& p2, const Vec3d& p3,
                 std::optional<double> tolerance) {
    if (p0 == p1 && p1 == p2 && p2 == p3) return 1;
    if (!tolerance)
        tolerance = hull_diagonal({Patch::Basis::bezier, 1, 4, {p0, p1, p2, p3}, {}}) / 2000;
    return curve_steps(p0, p1, p2, p3, border_share * *tolerance);
}

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
    std::array<int, 4> border(const BezierPatch& p) const {
        return {border_steps(p[0], p[1], p[2], p[3], tolerance),
                border_steps(p[3], p[7], p[11], p[15], tolerance),
                border_steps(p[15], p[14], p[13], p[12], tolerance),
                border_steps(p[12], p[8], p[4], p[0], tolerance)};
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
            for (const int steps : scaled.border(p)) triangles += steps;
            const Curvature curvature(p);
            // As if the whole patch were as curved as its worst part; looked at closely when in
            // doubt.
            double cells = chord_error(curvature.over(0, 1, 0, 1), 1, 1) / scaled.inside;
            if (!(2 * cells < 1e6)) {
                const GridSize n = grid_size(curvature, scaled.inside);
                cells = static_cast<double>(n.u) * n.v;
            }
            triangles += 2 * cells;
        }
    }
    return triangles <= static_cast<double>(triangle_limit);
}

std::optional<Mesh> tessellate(const Patch& patch, std::optional<double> tolerance) {
    if (is_single_point(patch.control)) return Mesh{};
    if (!is_within_limit(patch, tolerance)) return std::nullopt;
    const ScaledNet scaled(patch, tolerance);
    const BezierNet& net = scaled.net;
    Mesh mesh;
    for (std::size_t i = 0; i < net.rows; ++i) {
        for (std::size_t j = 0; j < net.columns; ++j) {
            const BezierPatch p = net.patch(i, j);
            PatchMesher(p, scaled.inside, scaled.border(p), {i, j, net.rows, net.columns}, mesh)
                .build();
        }
    }
    for (Vec3d& p : mesh.vertices) p = ScaledNet::scaled(p, scaled.exponent);
    return mesh;
}

}  // namespace lancer::splines
