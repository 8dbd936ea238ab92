// Rays that may go straight through a face next to the one that they start on: is_near_edge() of
// intersect/edge_hits.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Of rays that start on faces of one mesh, those so near to an edge that scalar code must look at
/// the adjacent faces. \param mask  not empty
[[gnu::noinline]] inline Mask near_edges(const Scene& scene, const Mesh& placed, const Rays& r,
                                         const Starts& starts, Mask mask) {
    const MeshShape& mesh = *placed.shape;
    Vectors start = r.origin + r.origin_lo;
    Numbers origin_error = r.origin_error;
    if (placed.frame != nothing) {
        const Rays local = to_local(r, scene.frames[placed.frame]);
        start = local.origin + local.origin_lo;
        origin_error = local.origin_error;
    }
    const Numbers zero = all(0.0);
    Vectors a{zero, zero, zero};
    Vectors b = a;
    Vectors c = a;
    for_each_lane(mask, [&](int i) {
        const std::uint32_t* corner = mesh.faces[starts.face[i]];
        set_lane(a, i, mesh.vertices[corner[0]]);
        set_lane(b, i, mesh.vertices[corner[1]]);
        set_lane(c, i, mesh.vertices[corner[2]]);
    });
    const Vectors ab = b - a;
    const Vectors ac = c - a;
    const Numbers size = max_component(absolute(ab)) + max_component(absolute(ac));
    const Numbers reach =
        all(4.0) * origin_error + bound<16>() * (max_component(absolute(start)) + size);
    const Vectors n = cross(ab, ac);
    const Vectors from_a = start - a;
    const Numbers square = dot(n, n);
    const Numbers u = dot(cross(from_a, ac), n) / square;
    const Numbers v = dot(cross(ab, from_a), n) / square;
    const Numbers area = root(square);
    const auto is_far = [&](const Numbers& weight, const Vectors& edge) {
        const Numbers edge_square = dot(edge, edge);
        return is_sound_square(edge_square) & less(reach * root(edge_square), weight * area);
    };
    const Mask far =
        is_sound_square(square) & is_far(u, ac) & is_far(v, ab) & is_far(all(1.0) - u - v, ac - ab);
    return mask & ~far;
}

/// The same for rays that start anywhere: those for which adjacent_face_hit() may find a face.
LANCER_INLINE Mask near_edges(const Scene& scene, const Rays& r, const Starts& starts,
                              Mask active) {
    if (!scene.has_clear_meshes) return 0;
    Mask on_meshes = 0;
    for_each_lane(active & ~equal(starts.item, nothing), [&](int i) {
        const Item& item = scene.items[starts.item[i]];
        if (item.kind == Kind::mesh && item.clear) on_meshes |= Mask(1) << i;
    });
    Mask near = 0;
    while (on_meshes != 0) {
        const std::uint32_t item = starts.item[__builtin_ctz(on_meshes)];
        const Mask same = on_meshes & equal(starts.item, item);
        near |= near_edges(scene, scene.meshes[scene.items[item].shape.index], r, starts, same);
        on_meshes &= ~same;
    }
    return near;
}

}  // namespace lancer::wide::LANCER_LEVEL
