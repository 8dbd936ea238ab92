// A patch as POV-Ray draws it, for the judge: flat facets with interpolated normals.
#pragma once

#include <limits>

#include "tracer/rays/crossing.h"
#include "tracer/rays/shear.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/traits.h"
#include "tracer/shapes/triangle.h"
#include "tracer/splines/bicubic.h"

namespace lancer {

/// A patch or net in the world. POV-Ray 3.7 halves each Bezier patch `halvings` times in both
/// directions (`bicubic_patch` of type 1 with flatness 0), and makes two triangles of the corners
/// of each cell. The triangles are not stored: each ray halves the patch anew.
template <class Real>
struct FacetSurface {
    struct Home {
        splines::Bicubic<Real> points;
        Real column, row;  ///< place of the Bezier patch in its net
    };
    std::vector<Home> homes;
    Real columns = 1, rows = 1;  ///< size of the net
    int halvings = 0;
    Real reach = 0;  ///< largest absolute coordinate of all control points, and so of all facets
};

/// One instance of such a patch. The number of a face consists of the number of its Bezier patch,
/// two bits for each quarter that leads to its cell, and one bit for the triangle in the cell.
template <class Real>
struct FacetSolid {
    const FacetSurface<Real>* surface;

    static constexpr SolidTraits traits{.convex = false, .face_by_face = false};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

/// Halves a cubic Bezier curve; its points have the indices first, first + step, ... De Casteljau;
/// Farin, Curves and Surfaces for CAGD, section 4.
template <class Real>
void halve(splines::Bicubic<Real>& low, splines::Bicubic<Real>& high, std::size_t first,
           std::size_t step) {
    const auto at = [&](std::size_t i) -> Vec3<Real>& { return low[first + i * step]; };
    const Vec3<Real> ab = (at(0) + at(1)) / Real(2);
    const Vec3<Real> bc = (at(1) + at(2)) / Real(2);
    const Vec3<Real> cd = (at(2) + at(3)) / Real(2);
    const Vec3<Real> abc = (ab + bc) / Real(2);
    const Vec3<Real> bcd = (bc + cd) / Real(2);
    const Vec3<Real> middle = (abc + bcd) / Real(2);
    high[first] = middle;
    high[first + step] = bcd;
    high[first + 2 * step] = cd;
    high[first + 3 * step] = at(3);
    at(1) = ab;
    at(2) = abc;
    at(3) = middle;
}

/// The four quarters. Bit 0 of the index: the second half along a row. Bit 1: the second half from
/// row to row.
template <class Real>
std::array<splines::Bicubic<Real>, 4> quarters(const splines::Bicubic<Real>& points) {
    std::array<splines::Bicubic<Real>, 4> out;
    out[0] = points;
    for (std::size_t column = 0; column < 4; ++column) halve(out[0], out[2], column, 4);
    for (std::size_t row = 0; row < 4; ++row) {
        halve(out[0], out[1], 4 * row, 1);
        halve(out[2], out[3], 4 * row, 1);
    }
    return out;
}

/// The corners of the two triangles, as indices into a cell's 16 points.
inline constexpr std::array<std::array<std::size_t, 3>, 2> facet_corners = {
    {{0, 3, 15}, {0, 15, 12}}};

template <class Real>
TriangleSheet<Real> facet(const splines::Bicubic<Real>& cell, std::size_t which) {
    const auto& corner = facet_corners[which];
    return {cell[corner[0]], cell[corner[1]], cell[corner[2]], Real(0)};
}

/// POV-Ray treats two directions as parallel if the squared sine of their angle is below this.
template <class Real>
inline constexpr Real no_plane = Real(1e-10L);

/// Whether the line meets a ball around the points, which contains all facets that they span.
template <class Real>
bool may_meet(const splines::Bicubic<Real>& points, const Ray<Real>& ray) {
    using std::sqrt;
    Vec3<Real> middle(0);
    for (const Vec3<Real>& p : points) middle += p / Real(16);
    Real radius = 0;
    for (const Vec3<Real>& p : points) radius = std::max(radius, length_squared(p - middle));
    const Vec3<Real> away = -start_from(ray, middle);
    const Real reach = sqrt(radius) + gamma<Real>(64) * (length(away) + length(middle));
    return length_squared(cross(away, ray.dir)) <= reach * reach * ray.dir_squared;
}

template <class Real, class Last, class Report>
class FacetSearch {
  public:
    FacetSearch(const Ray<Real>& ray, const RayInterval<Real, Last>& interval,
                const FacetSurface<Real>& surface, Report& report)
        : ray_(ray),
          interval_(interval),
          shear_(shear_of(ray)),
          halvings_(surface.halvings),
          report_(report) {
        shear_.noise = edge_noise(ray, surface.reach);
    }

    /// Returns true to stop.
    bool visit(const splines::Bicubic<Real>& points, std::uint32_t cell, int depth) {
        if (!may_meet(points, ray_)) return false;
        if (depth == halvings_) return meet(points, cell);
        const auto parts = quarters(points);
        for (std::uint32_t i = 0; i < 4; ++i)
            if (visit(parts[i], 4 * cell + i, depth + 1)) return true;
        return false;
    }

  private:
    bool meet(const splines::Bicubic<Real>& points, std::uint32_t cell) {
        for (std::uint32_t which = 0; which < 2; ++which) {
            const TriangleSheet<Real> triangle = facet(points, which);
            const Vec3<Real> ab = triangle.b - triangle.a;
            const Vec3<Real> ac = triangle.c - triangle.a;
            if (!(length_squared(cross(ab, ac)) >
                  no_plane<Real> * length_squared(ab) * length_squared(ac)))
                continue;
            TriangleHit<Real> hit;
            if (intersect(triangle, ray_, shear_, interval_, hit) &&
                report_(Crossing<Real>{hit.t, hit.error, 2 * cell + which, hit.entering}, hit.u,
                        hit.v))
                return true;
        }
        return false;
    }

    const Ray<Real>& ray_;
    const RayInterval<Real, Last>& interval_;
    Shear<Real> shear_;
    int halvings_;
    Report& report_;
};

template <class Real, class Last, class Report>
void crossings(const FacetSolid<Real>& solid, const Ray<Real>& ray,
               const IntersectionHints& /*hints*/, const RayInterval<Real, Last>& interval,
               Report&& report) {
    const FacetSurface<Real>& surface = *solid.surface;
    FacetSearch<Real, Last, Report> search(ray, interval, surface, report);
    for (std::uint32_t i = 0; i < surface.homes.size(); ++i)
        if (search.visit(surface.homes[i].points, i, 0)) return;
}

/// POV-Ray's normal of a Bezier patch: a unit vector; the world's x axis where there is none.
template <class Real>
Vec3<Real> facet_normal(const splines::Bicubic<Real>& points, const Vec2<Real>& place) {
    const splines::PatchSample<Real> at =
        splines::sample(points, splines::Place<Real>(place.x), splines::Place<Real>(place.y));
    const Vec3<Real> n = cross(at.dv, at.du);
    if (!(length_squared(n) > no_plane<Real> * length_squared(at.du) * length_squared(at.dv)))
        return Vec3<Real>(1, 0, 0);
    return normalize(n);
}

/// The point at the barycentric coordinates u, v of a face. Its shading normal interpolates the
/// true normals at the corners; its parameters are linear within the triangle.
template <class Real>
SurfacePoint<Real> facet_point(const FacetSolid<Real>& solid, std::uint32_t face, Real u, Real v) {
    const FacetSurface<Real>& surface = *solid.surface;
    const std::uint32_t cell = face / 2;
    const auto& home = surface.homes[cell >> (2 * surface.halvings)];
    splines::Bicubic<Real> points = home.points;
    Vec2<Real> low(0);
    Real size = 1;
    for (int depth = surface.halvings; depth-- > 0;) {
        const std::uint32_t quarter = cell >> (2 * depth) & 3;
        points = quarters(points)[quarter];
        size /= 2;
        low += size * Vec2<Real>(static_cast<Real>(quarter & 1), static_cast<Real>(quarter >> 1));
    }
    SurfacePoint<Real> p = triangle_point(facet(points, face % 2), u, v);
    const std::array<Real, 3> weights = {1 - u - v, u, v};
    Vec2<Real> place(0);
    p.shading = Vec3<Real>(0);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t corner = facet_corners[face % 2][i];
        const Vec2<Real> at = low + size * Vec2<Real>(static_cast<Real>(corner % 4 == 3),
                                                      static_cast<Real>(corner >= 12));
        p.shading += weights[i] * facet_normal(home.points, at);
        place += weights[i] * at;
    }
    p.parameter =
        Vec2<Real>((home.column + place.x) / surface.columns, (home.row + place.y) / surface.rows);
    return p;
}

}  // namespace lancer
