#include "tracer/tessellation/tessellate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "model/patch_net.h"
#include "model/splines.h"
#include "tracer/splines/bicubic.h"
#include "tracer/tessellation/cover.h"
#include "tracer/tessellation/grid_size.h"

namespace lancer::splines {
namespace {

/// Adds a patch's triangles. Its row and column in the net give the texture coordinates.
void add(const Triangulation& cover, const Bicubic<double>& p, std::size_t row, std::size_t column,
         const BezierNet& net, Mesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const FootPoint& v : cover.vertices) {
        mesh.vertices.push_back(v.point);
        mesh.normals.push_back(normal(p, v.at.x, v.at.y));
        mesh.uvs.emplace_back(
            (static_cast<double>(column) + v.at.x) / static_cast<double>(net.columns),
            (static_cast<double>(row) + v.at.y) / static_cast<double>(net.rows));
    }
    for (const Face& f : cover.faces) {
        // At a pole two corners may be the same point.
        const Vec3d& a = cover.vertices[f[0]].point;
        const Vec3d& b = cover.vertices[f[1]].point;
        const Vec3d& c = cover.vertices[f[2]].point;
        if (a == b || b == c || c == a) continue;
        mesh.faces.push_back({first + f[0], first + f[1], first + f[2]});
    }
}

/// A net in units of its size, so that squares of lengths stay in the range of doubles.
struct ScaledNet {
    BezierNet net;
    int exponent;                     ///< the original points are these times 2^exponent
    std::optional<double> tolerance;  ///< the given one, scaled
    double inside;  ///< the tolerance in use, not below the rounding errors of the points

    ScaledNet(const Patch& patch, std::optional<double> given) : net(bezier_net(patch)) {
        const double size = hull_diagonal(patch);
        exponent = std::ilogb(size);
        for (Vec3d& p : net.points) p = scaled(p, -exponent);
        if (given) tolerance = std::ldexp(*given, -exponent);
        double farthest = 0;
        for (const Vec3d& p : net.points) farthest = std::max(farthest, length(p));
        inside = std::max(tolerance.value_or(std::ldexp(size, -exponent) / 2000),
                          16 * std::numeric_limits<double>::epsilon() * farthest);
    }

    static Vec3d scaled(const Vec3d& p, int exponent) {
        return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    }

    /// Number of steps along each side.
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
            steps[k] = is_point ? 1 : border_steps(c, within);
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
            // First as if the whole patch were as curved as its worst part; a better estimate
            // follows only if that gives very many cells.
            double cells = chord_error(Curvature(p).largest_lengths(), 1, 1) / scaled.inside;
            if (!(2 * cells < 1e6)) {
                const Grid n = likely_grid(p, scaled.inside);
                cells = static_cast<double>(n.u) * n.v;
            }
            triangles += 2 * cells;
            for (const BorderCurve& c : border_curves(p)) {
                const double within = border_tolerance(c, scaled.tolerance);
                if (within > 0) triangles += likely_border_steps(c, within);
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
            add(cover({p, scaled.inside}, scaled.border(p, borders)), p, i, j, net, mesh);
        }
    }
    for (Vec3d& p : mesh.vertices) p = ScaledNet::scaled(p, scaled.exponent);
    return mesh;
}

}  // namespace lancer::splines
