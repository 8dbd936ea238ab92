// How far a mesh is from the patch that it stands for, measured in long double.
#pragma once

#include <algorithm>
#include <random>

#include "model/patch_net.h"
#include "tracer/splines/bicubic.h"

namespace lancer::splines {

using Wide = long double;

inline Bicubic<Wide> wide(const BezierPatch& p) {
    Bicubic<Wide> w;
    for (std::size_t i = 0; i < 16; ++i) w[i] = convert<Wide>(p[i]);
    return w;
}

/// Upper bound of the distance from q to the patch, the search ending once it is no more than
/// `enough`: the best found by Gauss-Newton steps from (u, v).
inline Wide distance(const Bicubic<Wide>& p, const Vec3<Wide>& q, Wide u, Wide v, Wide enough) {
    Wide best = std::numeric_limits<Wide>::infinity();
    for (int i = 0; i < 6 && best > enough; ++i) {
        const auto s = sample(p, Place<Wide>(u), Place<Wide>(v));
        const Vec3<Wide> d = q - s.point;
        best = std::min(best, length(d));
        const Wide a = dot(s.du, s.du);
        const Wide b = dot(s.du, s.dv);
        const Wide c = dot(s.dv, s.dv);
        const Wide det = a * c - b * b;
        if (!(det > 0)) break;
        const Wide x = dot(s.du, d);
        const Wide y = dot(s.dv, d);
        u = std::clamp<Wide>(u + (c * x - b * y) / det, 0, 1);
        v = std::clamp<Wide>(v + (a * y - b * x) / det, 0, 1);
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
                worst = std::max(worst, distance(p, q, u, v, worst));
            }
        }
    }
    return worst;
}

/// A square of `factor`, moved about in its own plane and bent.
inline Patch random_patch(unsigned seed, double factor, double flatness) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> shift(-1, 1);
    Patch patch;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            const double bend = flatness * 2;
            patch.control.push_back(Vec3d(j + 0.4 * shift(generator), bend * shift(generator),
                                          i + 0.4 * shift(generator)) *
                                    (factor / 3));
        }
    }
    return patch;
}

}  // namespace lancer::splines
