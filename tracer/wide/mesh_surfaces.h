// The surfaces of eight hits with faces of one mesh: triangle_point(), shading_normal() and
// make_surface() for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// weighted_point_error()
LANCER_INLINE Numbers weighted_point_error(const Vectors& ab, const Vectors& ac,
                                           const Vectors& normal, const Numbers& u,
                                           const Numbers& v) {
    const Vectors b = absolute(ab);
    const Vectors c = absolute(ac);
    const Numbers anyhow = bound<5>() * (max_component(b) + max_component(c));
    const Vectors off{b.y * c.z + b.z * c.y, b.z * c.x + b.x * c.z, b.x * c.y + b.y * c.x};
    const Vectors n = absolute(normal);
    const Numbers least = max_component(n) - bound<4>() * max_component(off);
    const Vectors terms = absolute(u) * b + absolute(v) * c;
    const Numbers along = bound<6>() * dot(n + bound<4>() * off, terms) / least;
    return select(less(all(0.0), least) & less(along, anyhow), along, anyhow);
}

/// unit(); adds to `odd` the lanes whose squared length overflows or underflows.
LANCER_INLINE Vectors unit(const Vectors& v, Mask& odd) {
    const Numbers square = dot(v, v);
    const Mask is_unit = at_most(absolute(square - all(1.0)), all(4 * 0x1p-52));
    odd |= ~is_unit & ~is_sound_square(square);
    return select(is_unit, v, v / root(square));
}

/// \return the hits that are left to scalar code
[[gnu::noinline]] inline Mask put_mesh(const Scene& scene, const Mesh& placed,
                                       const NearestHits& hits, Mask mask, Surfaces& s) {
    const MeshShape& mesh = *placed.shape;
    const Numbers zero = all(0.0);
    const Numbers one = all(1.0);
    Vectors a{zero, zero, zero};
    Vectors b = a;
    Vectors c = a;
    Vectors na = a;
    Vectors nb = a;
    Vectors nc = a;
    Mask smooth = 0;
    for_each_lane(mask, [&](int i) {
        const std::uint32_t* corner = mesh.faces[hits.face[i]];
        set_lane(a, i, mesh.vertices[corner[0]]);
        set_lane(b, i, mesh.vertices[corner[1]]);
        set_lane(c, i, mesh.vertices[corner[2]]);
        if (mesh.normals == nullptr) return;
        const std::uint32_t* normal = mesh.normal_faces[hits.face[i]];
        if (normal[0] == nothing || normal[1] == nothing || normal[2] == nothing) return;
        set_lane(na, i, mesh.normals[normal[0]]);
        set_lane(nb, i, mesh.normals[normal[1]]);
        set_lane(nc, i, mesh.normals[normal[2]]);
        smooth |= Mask(1) << i;
    });
    const Vectors ab = b - a;
    const Vectors ac = c - a;
    const Vectors flat = cross(ab, ac);
    const Vectors offset = hits.u * ab + hits.v * ac;
    Numbers error = weighted_point_error(ab, ac, flat, hits.u, hits.v);
    const Vectors sum = (one - hits.u - hits.v) * na + hits.u * nb + hits.v * nc;
    smooth &= less(zero, dot(sum, sum));
    const Vectors shading = select(smooth, sum, flat);
    s.note(mask, a, offset, error);
    Mask odd = 0;
    VectorPair place;
    Vectors geometric, normal;
    if (placed.frame == nothing) {
        place = two_sum(a, offset);
        geometric = unit(flat, odd);
        normal = unit(shading, odd);
    } else {
        const Frame& frame = scene.frames[placed.frame];
        const Moved moved(frame, a, offset, error);
        place = moved.place;
        error = moved.error;
        geometric = unit(map_transposed(frame.linear_inverse, flat), odd);
        normal = unit(map_transposed(frame.linear_inverse, shading), odd);
    }
    put(mask & ~odd, place, error, geometric, s);
    s.normal = select(mask & ~odd, normal, s.normal);
    return mask & odd;
}

}  // namespace lancer::wide::LANCER_LEVEL
