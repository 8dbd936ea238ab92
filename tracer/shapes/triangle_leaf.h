// The triangles of a leaf, side by side.
#pragma once

#include "tracer/numerics/lanes.h"
#include "tracer/rays/shear.h"
#include "tracer/shapes/triangle.h"

namespace lancer {

/// Up to four faces of a mesh, with all their data contiguous in memory, so that one instruction
/// can test several.
template <class Real>
struct TriangleLeaf {
    static constexpr std::uint32_t size = 4;

    std::array<std::array<std::array<Real, size>, 3>, 3> corner{};  ///< by corner, axis, triangle
    std::array<std::uint32_t, size> face{};

    void set(std::size_t i, std::uint32_t mesh_face, const TriangleSheet<Real>& triangle) {
        face[i] = mesh_face;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            corner[0][axis][i] = triangle.a[static_cast<int>(axis)];
            corner[1][axis][i] = triangle.b[static_cast<int>(axis)];
            corner[2][axis][i] = triangle.c[static_cast<int>(axis)];
        }
    }
    TriangleSheet<Real> triangle(std::size_t i) const {
        const auto place = [&](const std::array<std::array<Real, size>, 3>& c) {
            return Vec3<Real>(c[0][i], c[1][i], c[2][i]);
        };
        return {place(corner[0]), place(corner[1]), place(corner[2])};
    }
};

/// about_from_start() for the coordinates of four corners along one axis.
template <class Real>
[[gnu::always_inline]] inline Four<Real> about_from_start(const Ray<Real>& ray, int axis,
                                                          const std::array<Real, 4>& places) {
    if constexpr (has_fast_wider<Real>) {
        if (!ray.whole)
            return narrowed_difference(Four<Real>(places),
                                       double(ray.origin[axis]) + double(ray.origin_lo[axis]));
    }
    return Four<Real>(places) - Four<Real>(ray.origin[axis]);
}

/// Bit i: whether the ray may meet triangle i. The numbers are the same as for a single triangle.
template <class Real>
[[gnu::always_inline]] inline unsigned may_meet(const TriangleLeaf<Real>& leaf,
                                                const Ray<Real>& ray, const Shear<Real>& s) {
    using Four = Four<Real>;
    struct Across {
        Four x, y;
    };
    const Four sx(s.sx);
    const Four sy(s.sy);
    const auto across = [&](const std::array<std::array<Real, 4>, 3>& corner) {
        const auto along = [&](int axis) {
            return about_from_start(ray, axis, corner[static_cast<std::size_t>(axis)]);
        };
        const Four z = along(s.z);
        return Across{along(s.x) - sx * z, along(s.y) - sy * z};
    };
    const Across a = across(leaf.corner[0]);
    const Across b = across(leaf.corner[1]);
    const Across c = across(leaf.corner[2]);
    const Four u = c.x * b.y - c.y * b.x;
    const Four v = a.x * c.y - a.y * c.x;
    const Four w = b.x * a.y - b.y * a.x;
    return ~(less(smaller(smaller(u, v), w), Four(-s.noise)) &
             less(Four(s.noise), larger(larger(u, v), w)));
}

}  // namespace lancer
