// Measures the distance of a mesh from its patch, in long double.
#pragma once

#include <algorithm>

#include "model/patch_net.h"
#include "tracer/splines/bicubic.h"

namespace lancer::splines {

using Wide = long double;

inline Bicubic<Wide> wide(const BezierPatch& p) {
    Bicubic<Wide> w;
    for (std::size_t i = 0; i < 16; ++i) w[i] = convert<Wide>(p[i]);
    return w;
}

/// Distance from q to the best place found by Gauss-Newton steps from (u, v), or to the first that
/// is no more than `enough` away.
template <class Real>
Real distance_near(const Bicubic<Real>& p, const Vec3<Real>& q, Vec2<Real> at, Real enough) {
    Real best = std::numeric_limits<Real>::infinity();
    for (int i = 0; i < 8 && best > enough; ++i) {
        const auto s = sample(p, Place<Real>(at.x), Place<Real>(at.y));
        const Vec3<Real> d = q - s.point;
        best = std::min(best, length(d));
        const Real a = dot(s.du, s.du);
        const Real b = dot(s.du, s.dv);
        const Real c = dot(s.dv, s.dv);
        const Real x = dot(s.du, d);
        const Real y = dot(s.dv, d);
        // At a border that a step would cross.
        const bool u_ends = (at.x <= 0 && x < 0) || (at.x >= 1 && x > 0);
        const bool v_ends = (at.y <= 0 && y < 0) || (at.y >= 1 && y > 0);
        const Real det = a * c - b * b;
        Vec2<Real> step(u_ends || !(a > 0) ? 0 : x / a, v_ends || !(c > 0) ? 0 : y / c);
        if (!u_ends && !v_ends && det > Real(1e-12) * a * c)
            step = {(c * x - b * y) / det, (a * y - b * x) / det};
        at = {std::clamp<Real>(at.x + step.x, 0, 1), std::clamp<Real>(at.y + step.y, 0, 1)};
    }
    return best;
}

/// Upper bound of the distance from q to the patch, the search ending once it is no more than
/// `enough`: from `at`, then from all over the patch.
template <class Real>
Real distance(const Bicubic<Real>& p, const Vec3<Real>& q, const Vec2<Real>& at, Real enough) {
    Real best = distance_near(p, q, at, enough);
    constexpr int starts = 20;
    for (int k = 0; k < starts * starts && best > enough; ++k) {
        const Vec2<Real> from((Real(k % starts) + Real(0.5)) / starts,
                              (Real(k / starts) + Real(0.5)) / starts);
        best = std::min(best, distance_near(p, q, from, enough));
    }
    return best;
}

/// The largest distance of sampled points of the mesh from the net's true surface, of one triangle
/// in `every`.
inline Wide measured_distance(const Patch& patch, const Mesh& mesh, int samples,
                              std::size_t every = 1) {
    const BezierNet net = bezier_net(patch);
    Wide worst = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); f += every) {
        const Mesh::Corners& face = mesh.faces[f];
        Vec2<Wide> middle(0, 0);
        for (const auto corner : face)
            middle += Vec2<Wide>(mesh.uvs[corner].x, mesh.uvs[corner].y) / Wide(3);
        const auto column =
            std::min(net.columns - 1, static_cast<std::size_t>(middle.x * net.columns));
        const auto row = std::min(net.rows - 1, static_cast<std::size_t>(middle.y * net.rows));
        const auto p = wide(net.patch(row, column));
        for (int i = 0; i <= samples; ++i) {
            for (int j = 0; i + j <= samples; ++j) {
                const std::array<Wide, 3> w{Wide(i) / samples, Wide(j) / samples,
                                            Wide(samples - i - j) / samples};
                Vec3<Wide> q(0);
                Vec2<Wide> uv(0, 0);
                for (std::size_t k = 0; k < 3; ++k) {
                    q += w[k] * convert<Wide>(mesh.vertices[face[k]]);
                    uv += w[k] * Vec2<Wide>(mesh.uvs[face[k]].x, mesh.uvs[face[k]].y);
                }
                const Wide u = std::clamp<Wide>(uv.x * net.columns - column, 0, 1);
                const Wide v = std::clamp<Wide>(uv.y * net.rows - row, 0, 1);
                worst = std::max(worst, distance(p, q, {u, v}, worst));
            }
        }
    }
    return worst;
}

}  // namespace lancer::splines
