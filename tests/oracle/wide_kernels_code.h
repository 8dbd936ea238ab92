// The body of wide_kernels_*.cpp.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

inline Rays rays_of(const LaneRay* from) {
    const Numbers zero = all(0.0);
    Vectors origin{zero, zero, zero};
    Vectors origin_lo = origin;
    Vectors dir = origin;
    Numbers error = zero;
    for (int i = 0; i < lanes; ++i) {
        set_lane(origin, i, from[i].origin);
        set_lane(origin_lo, i, from[i].origin_lo);
        set_lane(dir, i, from[i].dir);
        set_lane(error, i, from[i].origin_error);
    }
    return make_rays(origin, origin_lo, dir, error);
}

inline void put_answers(const NearestHits& hits, oracle::WideAnswer* out) {
    for (int i = 0; i < lanes; ++i) {
        out[i] = {(hits.some >> i & 1) != 0,
                  (hits.unsure >> i & 1) != 0,
                  (hits.entering >> i & 1) != 0,
                  lane(hits.t, i),
                  lane(hits.error, i),
                  0,
                  0};
    }
}

inline void put_answers(Mask hit, Mask unsure, oracle::WideAnswer* out) {
    for (int i = 0; i < lanes; ++i)
        out[i] = {(hit >> i & 1) != 0, (unsure >> i & 1) != 0, false, 0, 0, 0, 0};
}

/// All eight on a face of the first item, or on nothing.
///
/// \param normals  of what they start on; null: unknown
inline Starts starts_on(std::uint32_t face, const double (*normals)[3]) {
    Starts starts;
    put_some(starts.item, 255, face == nothing ? nothing : 0);
    put_some(starts.left, 255, nothing);
    put_some(starts.face, 255, face);
    if (normals != nullptr) {
        starts.planes = 255;
        for (int i = 0; i < lanes; ++i) set_lane(starts.normal, i, normals[i]);
    }
    return starts;
}

inline void ball_kernel(const Ball& ball, const LaneRay* rays, double limit,
                        oracle::WideAnswer* out) {
    NearestHits hits;
    hits.limit = all(limit);
    ball_crossings(ball, 0, rays_of(rays), 255, Ways(), hits);
    put_answers(hits, out);
}
inline void from_ball_kernel(const Ball& ball, const LaneRay* rays, oracle::WideAnswer* out) {
    const BallFromSurface other(ball, rays_of(rays));
    for (int i = 0; i < lanes; ++i)
        out[i] = {true, false, false, lane(other.t, i), lane(other.error, i), 0, 0};
}
inline void box_kernel(const Box& box, const LaneRay* rays, double limit, oracle::WideAnswer* out) {
    NearestHits hits;
    hits.limit = all(limit);
    box_crossings(box, 0, rays_of(rays), 255, Ways(), hits);
    put_answers(hits, out);
    for (int i = 0; i < lanes; ++i) out[i].face = out[i].hit ? hits.face[i] : 0;
}
inline void frustum_kernel(const Ball& around, const Frustum& frustum, const LaneRay* rays,
                           double limit, oracle::WideAnswer* out) {
    NearestHits hits;
    hits.limit = all(limit);
    hits.unsure |= frustum_crossings(around, frustum, 0, rays_of(rays), 255, hits);
    put_answers(hits, out);
    for (int i = 0; i < lanes; ++i) out[i].face = out[i].hit ? hits.face[i] : 0;
}
inline void torus_kernel(const Torus& torus, const LaneRay* rays, double limit,
                         oracle::WideAnswer* out) {
    NearestHits hits;
    hits.limit = all(limit);
    hits.unsure |= torus_crossings(Scene{}, torus, 0, rays_of(rays), 255, 0, hits);
    put_answers(hits, out);
}
inline void disc_kernel(const Disc& disc, const LaneRay* rays, oracle::WideAnswer* out) {
    put_answers(0, may_meet(disc, rays_of(rays)), out);
}
inline void patch_kernel(ExactMethods& exact, const LaneRay* from, std::uint32_t face,
                         const double (*normals)[3], double limit, oracle::WideAnswer* out) {
    NearestHits hits;
    hits.limit = all(limit);
    const Rays rays = rays_of(from);
    Job job{};
    job.exact = &exact;
    const Starts starts = starts_on(face, normals);
    PatchSpaces spaces;
    patch_crossings(job, 0, spaces.rays_in(Scene{}, {nothing}, rays, starts), starts, 255, hits);
    put_answers(hits, out);
    for (int i = 0; i < lanes; ++i) {
        out[i].u = lane(hits.u, i);
        out[i].v = lane(hits.v, i);
        out[i].face = out[i].hit ? hits.face[i] : 0;
    }
}
inline void plane_kernel(const Plane& plane, const LaneRay* rays, double limit,
                         oracle::WideAnswer* out) {
    NearestHits hits;
    hits.limit = all(limit);
    plane_crossings(plane, 0, rays_of(rays), 255, hits);
    put_answers(hits, out);
}

inline void triangle_kernel(const TriangleBlock& block, double reach, const LaneRay* from,
                            double limit, oracle::WideAnswer* out) {
    const Rays rays = rays_of(from);
    Shears shears;
    shears.set(rays, reach, 255);
    put_answers(0, 0, out);
    const TriangleCorners corners(block, 0);
    for (int k = 0; k < shears.count; ++k) {
        const Shears::Group& g = shears.groups[k];
        const Mask may = corners.may_meet(rays, shears, g) & g.mask;
        for_each_lane(g.mask, [&](int i) {
            out[i].unsure = (may_meet(block, rays, shears, g, i) & 1) != (may >> i & 1);
        });
        if (may == 0) continue;
        const TriangleHits hits = intersect_exactly(corners, rays, shears, g, may, all(limit));
        for_each_lane(hits.mask, [&](int i) {
            out[i] = {true,
                      out[i].unsure,
                      (hits.entering >> i & 1) != 0,
                      lane(hits.t, i),
                      lane(hits.error, i),
                      lane(hits.u, i),
                      lane(hits.v, i)};
        });
    }
}

inline void ball_shadow_kernel(const Ball& ball, const LaneRay* rays, double distance,
                               oracle::WideAnswer* out) {
    const BallShadow shadow(ball, rays_of(rays), 255, all(distance));
    put_answers(shadow.blocks, shadow.unsure, out);
}
inline void box_shadow_kernel(const Box& box, const LaneRay* rays, double distance,
                              oracle::WideAnswer* out) {
    const BoxShadow shadow(box, rays_of(rays), 255, all(distance));
    put_answers(shadow.blocks, shadow.unsure, out);
}
inline void frustum_shadow_kernel(const Ball& around, const Frustum& frustum, const LaneRay* rays,
                                  double distance, oracle::WideAnswer* out) {
    const FrustumShadow shadow(around, frustum, rays_of(rays), 255, all(distance));
    put_answers(shadow.blocks, shadow.unsure, out);
}
inline void torus_shadow_kernel(const Torus& torus, const LaneRay* rays, bool own, double distance,
                                oracle::WideAnswer* out) {
    const TorusShadow shadow(Scene{}, torus, rays_of(rays), 255, own ? 255 : 0, all(distance));
    put_answers(shadow.blocks, shadow.unsure, out);
}
inline void patch_shadow_kernel(ExactMethods& exact, const LaneRay* from, std::uint32_t face,
                                const double (*normals)[3], double distance,
                                oracle::WideAnswer* out) {
    const Rays rays = rays_of(from);
    Job job{};
    job.exact = &exact;
    const Starts starts = starts_on(face, normals);
    PatchSpaces spaces;
    const PatchShadow shadow(job, 0, spaces.rays_in(Scene{}, {nothing}, rays, starts), starts, 255,
                             all(distance));
    put_answers(shadow.blocks, shadow.unsure & ~shadow.blocks, out);
}
inline void plane_shadow_kernel(const Plane& plane, const LaneRay* rays, double distance,
                                oracle::WideAnswer* out) {
    const PlaneShadow shadow(plane, rays_of(rays), 255, all(distance));
    put_answers(shadow.blocks, shadow.unsure, out);
}

inline void slabs_kernel(const Tree& tree, const LaneRay* from, double limit,
                         oracle::WideSlabs* out) {
    const Rays rays = rays_of(from);
    const BoxRays boxes(tree, rays, 255, all(limit));
    for (int i = 0; i < lanes; ++i) out[i].misses = (boxes.misses >> i & 1) != 0;
    if (boxes.misses == 255) return;
    const Floats last = boxes.parameters(all(limit));
    const Mask met = enter_boxes(BoxRayPairs(boxes), tree.nodes[0], 0, both(last)).met;
    for (int i = 0; i < lanes; ++i) {
        for (int a = 0; a < 3; ++a) {
            out[i].enter_origin[a] = lane(boxes.slabs[a].enter_origin, i);
            out[i].leave_origin[a] = lane(boxes.slabs[a].leave_origin, i);
            out[i].enter_inverse[a] = lane(boxes.slabs[a].enter_inverse, i);
            out[i].leave_inverse[a] = lane(boxes.slabs[a].leave_inverse, i);
        }
        out[i].last = lane(last, i);
        out[i].met = (met >> i & 1) != 0;
    }
}

inline void local_kernel(const Frame& frame, const LaneRay* rays, LaneRay* out) {
    const Rays local = to_local(rays_of(rays), frame);
    for (int i = 0; i < lanes; ++i) out[i] = lane_ray(local, i);
}

inline void alone_kernel(const Mesh& mesh, const LaneRay* from, double limit, LaneRay* out,
                         oracle::WideSlabs* slabs) {
    const Rays rays = rays_of(from);
    for (int i = 0; i < lanes; ++i) {
        const LoneRay ray(rays, i, mesh);
        const auto put = [](const Fours& v, double(&to)[3]) {
            double each[4];
            store(each, v);
            for (int a = 0; a < 3; ++a) to[a] = each[a];
        };
        put(ray.origin, out[i].origin);
        put(ray.origin_lo, out[i].origin_lo);
        put(ray.dir, out[i].dir);
        put(ray.inv_dir, out[i].inv_dir);
        out[i].origin_error = ray.error(lane(rays.origin_error, i), mesh);
        out[i].whole = ray.whole;
        const LoneBoxRay box_ray(mesh.shape->tree, ray, limit);
        slabs[i].misses = box_ray.misses;
        if (box_ray.misses) continue;
        for (int a = 0; a < 3; ++a) {
            const LoneSlabs::Axis& axis = box_ray.slabs.axes[a];
            slabs[i].enter_origin[a] = lane(axis.enter_origin, 0);
            slabs[i].leave_origin[a] = lane(axis.leave_origin, 0);
            slabs[i].enter_inverse[a] = lane(axis.enter_inverse, 0);
            slabs[i].leave_inverse[a] = lane(axis.leave_inverse, 0);
        }
        slabs[i].last = box_ray.parameter(limit);
    }
}

inline void lone_mesh_kernel(const Mesh& mesh, const LaneRay* from, double limit,
                             oracle::WideAnswer* out, oracle::WideAnswer* shadow) {
    const Rays rays = rays_of(from);
    NearestHits hits;
    hits.limit = all(limit);
    Starts starts;
    put_some(starts.item, 255, nothing);
    Mask blocked = 0;
    Mask unsure = 0;
    for (int i = 0; i < lanes; ++i) {
        lone_mesh_crossings(mesh, 0, rays, starts, i, hits);
        const MeshShadow one = lone_mesh_shadow(mesh, 0, rays, starts, i, limit);
        blocked |= one.blocks;
        unsure |= one.unsure;
    }
    put_answers(hits, out);
    for (int i = 0; i < lanes; ++i) {
        out[i].u = lane(hits.u, i);
        out[i].v = lane(hits.v, i);
        out[i].face = hits.face[i];
    }
    put_answers(blocked, unsure & ~blocked, shadow);
}

inline void surfaces_kernel(const Scene& scene, ExactMethods& exact, const LaneRay* from,
                            const LaneHit* given, LaneSurface* out) {
    const Rays rays = rays_of(from);
    NearestHits hits;
    for (int i = 0; i < lanes; ++i) hits.add(i, given[i]);
    Job job{};
    job.scene = &scene;
    job.exact = &exact;
    Surfaces s;
    make_surfaces(job, rays, hits, 255, s);
    const auto put = [](const Vectors& v, int i, double* to) {
        to[0] = lane(v.x, i);
        to[1] = lane(v.y, i);
        to[2] = lane(v.z, i);
    };
    for (int i = 0; i < lanes; ++i) {
        put(s.position, i, out[i].position);
        put(s.position_lo, i, out[i].position_lo);
        put(s.geometric, i, out[i].geometric);
        put(s.normal, i, out[i].normal);
        put(s.color, i, out[i].color);
        out[i].error = lane(s.error, i);
        out[i].opacity = lane(s.opacity, i);
        out[i].outermost = s.convex[i] != nothing;
    }
}

inline void bend_kernel(const LaneRay* from, const double (*normals)[3], const double* ratios,
                        double (*bent)[3], oracle::WideAnswer* out) {
    const Rays rays = rays_of(from);
    const Numbers ratio = load(ratios);
    Vectors normal = rays.dir;
    for (int i = 0; i < lanes; ++i) set_lane(normal, i, normals[i]);
    const Refracted refracted(rays.dir, normal, ratio);
    const Numbers reflectance = fresnel_reflectance(-dot(normal, rays.dir), all(1.0) / ratio);
    for (int i = 0; i < lanes; ++i) {
        out[i] = {(refracted.total >> i & 1) != 0, false, false, lane(reflectance, i), 0, 0, 0};
        bent[i][0] = lane(refracted.bent.x, i);
        bent[i][1] = lane(refracted.bent.y, i);
        bent[i][2] = lane(refracted.bent.z, i);
    }
}

inline void power_kernel(const double* x, const double* y, double* out) {
    store(out, power(load(x), load(y)));
}
inline void arc_cosine_kernel(const double* x, double* out) {
    store(out, arc_cosine(load(x)));
}
inline void exponential_kernel(const double* x, double* out) {
    store(out, exponential(load(x)));
}

inline constexpr oracle::WideKernels kernels{
    ball_kernel,         from_ball_kernel,    box_kernel,          frustum_kernel,
    torus_kernel,        disc_kernel,         patch_kernel,        plane_kernel,
    triangle_kernel,     ball_shadow_kernel,  box_shadow_kernel,   frustum_shadow_kernel,
    torus_shadow_kernel, patch_shadow_kernel, plane_shadow_kernel, slabs_kernel,
    local_kernel,        alone_kernel,        lone_mesh_kernel,    surfaces_kernel,
    bend_kernel,         power_kernel,        arc_cosine_kernel,   exponential_kernel};

}  // namespace lancer::wide::LANCER_LEVEL
