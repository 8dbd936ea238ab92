// The shapes' own parameters (u, v), for images with `mapping uv`: docs/shading.md, "uv".
#pragma once

#include <array>
#include <variant>

#include "model/scene.h"
#include "tracer/rays/faces.h"
#include "tracer/rays/surface_point.h"
#include "tracer/textures/mapping.h"

namespace lancer {

// Charts: how the points of a shape get their (u, v). All in the shape's own space, unscaled.

/// Plane, triangle or mesh without uvs: u = x, v = y.
struct PlanarChart {};

template <class Real>
struct SphereChart {
    Vec3<Real> center;
};

template <class Real>
struct BoxChart {
    Vec3<Real> min;
    Vec3<Real> size;
};

template <class Real>
struct FrustumChart {
    Vec3<Real> base;
    Vec3<Real> x, y, z;  ///< unit: y from base to top, x perpendicular to it, z = x × y
    Real height;
    Real base_radius, top_radius;
    bool base_is_small;  ///< the base is the small cap (the tracer numbers caps by their size)
};

/// The uvs of a triangle's corners.
template <class Real>
struct TriangleChart {
    std::array<Vec2<Real>, 3> uvs;
};

struct MeshChart {
    const Mesh* mesh;  ///< with uvs
};

/// Patch, lathe, prism and torus: the tracer's shape computes (u, v) itself, in
/// SurfacePoint::parameter.
struct ParameterChart {};

template <class Real>
using Chart = std::variant<PlanarChart, SphereChart<Real>, BoxChart<Real>, FrustumChart<Real>,
                           TriangleChart<Real>, MeshChart, ParameterChart>;

/// The data of a hit that charts use.
template <class Real>
struct ChartPoint {
    PatternPoint<Real> object;      ///< in the object's space
    Vec3<Real> normal;              ///< geometric, outward, in the object's space, any length
    std::uint32_t face;             ///< its number in the tracer's shape
    const SurfacePoint<Real>& hit;  ///< in the primitive's space
};

template <class Real>
ImagePoint<Real> uv_at(const PlanarChart&, const ChartPoint<Real>& p) {
    return planar(p.object);
}

template <class Real>
ImagePoint<Real> uv_at(const SphereChart<Real>& chart, const ChartPoint<Real>& p) {
    return spherical(PatternPoint<Real>{p.object.at - chart.center, p.object.bound});
}

/// Each face has its own [0, 1]², upright and not mirrored as seen from outside.
template <class Real>
ImagePoint<Real> uv_at(const BoxChart<Real>& chart, const ChartPoint<Real>& p) {
    const Vec3<Real> steep = absolute(p.normal);
    const int axis = steep.x >= steep.y && steep.x >= steep.z ? 0 : (steep.y >= steep.z ? 1 : 2);
    const bool at_max = p.normal[axis] > 0;
    // NaN along an axis in which the box has no extent; faces with that coordinate have no points.
    const Vec3<Real> q = (p.object.at - chart.min) / chart.size;
    const Vec3<Real> bound = p.object.bound / chart.size + Vec3<Real>(gamma<Real>(4));
    if (axis == 0) return {at_max ? 1 - q.z : q.z, q.y, bound.z, bound.y};
    if (axis == 1) return {q.x, at_max ? 1 - q.z : q.z, bound.x, bound.z};
    return {at_max ? q.x : 1 - q.x, q.y, bound.x, bound.y};
}

/// Side: u about the axis, v from base to top. Caps: planar, with the disc inscribed in [0, 1]².
template <class Real>
ImagePoint<Real> uv_at(const FrustumChart<Real>& chart, const ChartPoint<Real>& p) {
    const Vec3<Real> rel = p.object.at - chart.base;
    const Real spread = p.object.bound.x + p.object.bound.y + p.object.bound.z;
    const Vec3<Real> own(dot(chart.x, rel), dot(chart.y, rel), dot(chart.z, rel));
    const bool base = (p.face == frustum_face::small_cap) == chart.base_is_small;
    const Real across = 2 * (base ? chart.base_radius : chart.top_radius);
    if (p.face == frustum_face::side || !(across > 0)) {
        const Vec3<Real> unit_high(own.x, own.y / chart.height, own.z);
        return cylindrical(PatternPoint<Real>{
            unit_high, Vec3<Real>(spread, spread / chart.height + gamma<Real>(4), spread)});
    }
    const Real bound = spread / across + gamma<Real>(4);
    return {Real(0.5) + own.x / across, Real(0.5) + own.z / across, bound, bound};
}

/// Interpolates the uvs of three corners by the barycentric coordinates of a triangle's hit.
template <class Real>
ImagePoint<Real> between(const std::array<Vec2<Real>, 3>& uvs, const Vec2<Real>& weights) {
    using std::abs;
    const Real first = 1 - weights.x - weights.y;
    const Vec2<Real> at = first * uvs[0] + weights.x * uvs[1] + weights.y * uvs[2];
    Vec2<Real> bound{};
    for (const Vec2<Real>& uv : uvs) bound += gamma<Real>(8) * Vec2<Real>(abs(uv.x), abs(uv.y));
    return {at.x, at.y, bound.x, bound.y};
}

template <class Real>
ImagePoint<Real> uv_at(const TriangleChart<Real>& chart, const ChartPoint<Real>& p) {
    return between(chart.uvs, p.hit.parameter);
}

/// If a corner of the face has no uv, the face is planar, like a mesh without uvs.
template <class Real>
ImagePoint<Real> uv_at(const MeshChart& chart, const ChartPoint<Real>& p) {
    const Mesh& mesh = *chart.mesh;
    const Mesh::Corners& corners =
        mesh.uv_faces.empty() ? mesh.faces[p.face] : mesh.uv_faces[p.face];
    std::array<Vec2<Real>, 3> uvs;
    for (std::size_t i = 0; i < uvs.size(); ++i) {
        if (corners[i] == none) return planar(p.object);
        const Vec2d& uv = mesh.uvs[corners[i]];
        uvs[i] = Vec2<Real>(static_cast<Real>(uv.x), static_cast<Real>(uv.y));
    }
    return between(uvs, p.hit.parameter);
}

template <class Real>
ImagePoint<Real> uv_at(const ParameterChart&, const ChartPoint<Real>& p) {
    constexpr Real bound = gamma<Real>(16);
    return {p.hit.parameter.x, p.hit.parameter.y, bound, bound};
}

}  // namespace lancer
