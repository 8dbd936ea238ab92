// Bounding boxes of primitives in world space.
#pragma once

#include "tracer/scene/geometry.h"

namespace lancer {

template <class Real>
Bounds<Real> solid_bounds(const BallSolid<Real>& s) {
    return around(s.center, Vec3<Real>(s.radius));
}

template <class Real>
Bounds<Real> solid_bounds(const BoxSolid<Real>& s) {
    return {s.min, s.max};
}

/// A disc of radius r perpendicular to the unit axis w extends by r sqrt(1 - w_i^2) along axis i.
template <class Real>
Bounds<Real> solid_bounds(const FrustumSolid<Real>& s) {
    using std::sqrt;
    const auto disc = [&](const Vec3<Real>& center, Real radius) {
        Vec3<Real> reach;
        for (int i = 0; i < 3; ++i) {
            const Real rest = (1 - s.axis[i]) * (1 + s.axis[i]) + gamma<Real>(4);
            reach[i] = radius * sqrt(rest > 0 ? rest : Real(0));
        }
        return around(center, reach);
    };
    Bounds<Real> b = disc(s.small_end, s.radius);
    b.extend(disc(s.large_end, s.radius + s.slope * s.height));
    return b;
}

template <class Real>
Bounds<Real> solid_bounds(const TorusSolid<Real>& s) {
    return around(Vec3<Real>(0), Vec3<Real>(s.reach(), s.tube, s.reach()) * s.grow);
}

template <class Real>
Bounds<Real> solid_bounds(const HalfSpace<Real>&) {
    return around(Vec3<Real>(0), Vec3<Real>(std::numeric_limits<Real>::infinity()));
}

template <class Real>
Bounds<Real> solid_bounds(const TriangleSheet<Real>& s) {
    Bounds<Real> b;
    b.extend(s.a);
    b.extend(s.b);
    b.extend(s.c);
    return b;
}

template <class Real>
Bounds<Real> solid_bounds(const MeshInstance<Real>& s) {
    return s.mesh->bvh.bounds;
}

template <class Real>
Bounds<Real> solid_bounds(const PatchSolid<Real>& s) {
    return s.surface->bounds();
}

template <class Real>
Bounds<Real> solid_bounds(const BicubicSolid<Real>& s) {
    return s.surface->bounds();
}

template <class Real>
Bounds<Real> solid_bounds(const FacetSolid<Real>& s) {
    Bounds<Real> b;
    for (const auto& home : s.surface->homes)
        for (const Vec3<Real>& p : home.points) b.extend(p);
    return b;
}

template <class Real>
Bounds<Real> solid_bounds(const LatheSolid<Real>& s) {
    const splines::Curve<Real>& c = s.surface->curve;
    Bounds<Real> b{Vec3<Real>(-c.max.x, c.min.y, -c.max.x), Vec3<Real>(c.max.x, c.max.y, c.max.x)};
    b.min = splines::scaled(b.min, c.exponent);
    b.max = splines::scaled(b.max, c.exponent);
    return b;
}

template <class Real>
Bounds<Real> solid_bounds(const PrismSolid<Real>& s) {
    const splines::Curve<Real>& c = s.surface->curve;
    return {splines::scaled(Vec3<Real>(c.min.x, s.surface->bottom, c.min.y), c.exponent),
            splines::scaled(Vec3<Real>(c.max.x, s.surface->top, c.max.y), c.exponent)};
}

template <class Real>
Bounds<Real> solid_bounds(const CompositeSolid<Real>& s) {
    return s.tree->bounds;
}

/// The bounds of a mapped box: the mapped centre, and the half extents mapped by absolute values.
template <class Real>
Bounds<Real> mapped(const Bounds<Real>& b, const Affine<Real>& map) {
    const Vec3<Real> center = (b.min + b.max) / Real(2);
    const Vec3<Real> half = (b.max - b.min) / Real(2);
    Vec3<Real> reach;
    for (int i = 0; i < 3; ++i)
        reach[i] = dot(absolute(map.rows[static_cast<std::size_t>(i)]),
                       half + gamma<Real>(8) * absolute(center));
    return around(map_point(map, center), reach);
}

template <class Real>
Bounds<Real> bounds_of(const Geometry<Real>& geometry, const Primitive<Real>& p) {
    const Bounds<Real> own =
        widened(std::visit([](const auto& solid) { return solid_bounds(solid); }, p.solid));
    return p.frame == none ? own : widened(mapped(own, geometry.frames[p.frame].to_world));
}

/// Visits boxes that together contain all items of a tree: the boxes `levels` levels below its
/// root, and leaves above them.
template <class Real, class Visit>
void for_each_box_near_root(const Bvh<Real>& bvh, const BvhNode<Real>& node, int levels,
                            Visit&& visit) {
    for (std::size_t c = 0; c < node.child.size() && node.child[c] != none; ++c) {
        if (levels > 1 && node.count[c] == 0) {
            for_each_box_near_root(bvh, bvh.nodes[node.child[c]], levels - 1, visit);
            continue;
        }
        visit(Bounds<Real>{{node.min[0][c], node.min[1][c], node.min[2][c]},
                           {node.max[0][c], node.max[1][c], node.max[2][c]}});
    }
}

/// The bounds of a mapped torus. A torus is the union of balls about the points of a circle. Along
/// an axis of the world, its extent is the sum of those of the mapped circle (an ellipse) and of
/// the mapped ball (an ellipsoid). The box is enlarged by some rounding errors, so that it contains
/// computed points as well.
template <class Real>
Bounds<Real> box_of_turned(const TorusSolid<Real>& torus, const Affine<Real>& to_world) {
    using std::sqrt;
    Vec3<Real> reach(0);
    for (int i = 0; i < 3; ++i) {
        const Vec3<Real>& given = to_world.rows[static_cast<std::size_t>(i)];
        const Real size = max_component(absolute(given));
        if (!(size > 0)) continue;
        const Vec3<Real> row = given / size;  // the squares stay in the number type's range
        const Real circle = sqrt(row.x * row.x + row.z * row.z);
        reach[i] = (torus.ring * circle + torus.tube * length(row)) * (size * torus.grow);
    }
    return widened(around(to_world.shift, reach * (1 + gamma<Real>(32))));
}

/// Bounds for the tree of the world. For a mesh with a frame they are the union of the mapped boxes
/// of its parts. The mapped box of the whole mesh has up to three times the area, and each ray that
/// meets it must be mapped to the mesh's space.
template <class Real>
Bounds<Real> box_in_tree(const Geometry<Real>& geometry, const Primitive<Real>& p) {
    Bounds<Real> box = bounds_of(geometry, p);
    if (const auto* torus = std::get_if<TorusSolid<Real>>(&p.solid); torus && p.frame != none)
        return box_of_turned(*torus, geometry.frames[p.frame].to_world);
    const auto* instance = std::get_if<MeshInstance<Real>>(&p.solid);
    if (instance == nullptr || p.frame == none) return box;
    const Bvh<Real>& tree = instance->mesh->bvh;
    if (tree.nodes.empty()) return box;
    Bounds<Real> parts;
    for_each_box_near_root(tree, tree.nodes.front(), 2, [&](const Bounds<Real>& part) {
        parts.extend(mapped(part, geometry.frames[p.frame].to_world));
    });
    parts = widened(parts);
    for (int i = 0; i < 3; ++i) {
        if (parts.min[i] > box.min[i]) box.min[i] = parts.min[i];
        if (parts.max[i] < box.max[i]) box.max[i] = parts.max[i];
    }
    return box;
}

}  // namespace lancer
