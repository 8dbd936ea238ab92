// The kernels for eight rays side by side, of each level, as functions that a test can call.
#pragma once

#include "tracer/wide/job.h"

namespace lancer::oracle {

/// A kernel's result for one shape and one of the rays.
struct WideAnswer {
    bool hit, unsure, entering;
    double t, error, u, v;
    std::uint32_t face = 0;
};

/// One ray as the box tests use it: SlabRay<float> for each axis, and whether it misses all boxes.
struct WideSlabs {
    bool misses;
    float enter_origin[3], leave_origin[3], enter_inverse[3], leave_inverse[3];
    float last;  ///< BoxRay::parameter() of the limit
    bool met;    ///< the ray may meet the node's first box
};

/// All take eight rays and answer for each.
struct WideKernels {
    void (*ball)(const wide::Ball& ball, const wide::LaneRay* rays, double limit, WideAnswer* out);
    /// From its surface: the second crossing.
    void (*from_ball)(const wide::Ball& ball, const wide::LaneRay* rays, WideAnswer* out);
    void (*box)(const wide::Box& box, const wide::LaneRay* rays, double limit, WideAnswer* out);
    void (*frustum)(const wide::Ball& around, const wide::Frustum& frustum,
                    const wide::LaneRay* rays, double limit, WideAnswer* out);
    void (*torus)(const wide::Torus& torus, const wide::LaneRay* rays, double limit,
                  WideAnswer* out);
    /// `unsure`: the line may meet it
    void (*disc)(const wide::Disc& disc, const wide::LaneRay* rays, WideAnswer* out);
    /// \param exact    knows the patch
    /// \param face     a piece that the rays start on, or `nothing`
    /// \param normals  of what they start on; null: unknown
    void (*patch)(wide::ExactMethods& exact, const wide::LaneRay* rays, std::uint32_t face,
                  const double (*normals)[3], double limit, WideAnswer* out);
    void (*plane)(const wide::Plane& plane, const wide::LaneRay* rays, double limit,
                  WideAnswer* out);
    /// Tests the first triangle of the block. `unsure`: the test of all four triangles excluded the
    /// first.
    void (*triangle)(const wide::TriangleBlock& block, double reach, const wide::LaneRay* rays,
                     double limit, WideAnswer* out);
    /// `hit`: the shape is between the ray's start and a light at this distance.
    void (*ball_shadow)(const wide::Ball& ball, const wide::LaneRay* rays, double distance,
                        WideAnswer* out);
    void (*box_shadow)(const wide::Box& box, const wide::LaneRay* rays, double distance,
                       WideAnswer* out);
    void (*frustum_shadow)(const wide::Ball& around, const wide::Frustum& frustum,
                           const wide::LaneRay* rays, double distance, WideAnswer* out);
    /// \param own  the rays start on it
    void (*torus_shadow)(const wide::Torus& torus, const wide::LaneRay* rays, bool own,
                         double distance, WideAnswer* out);
    void (*patch_shadow)(wide::ExactMethods& exact, const wide::LaneRay* rays, std::uint32_t face,
                         const double (*normals)[3], double distance, WideAnswer* out);
    void (*plane_shadow)(const wide::Plane& plane, const wide::LaneRay* rays, double distance,
                         WideAnswer* out);
    void (*slabs)(const wide::Tree& tree, const wide::LaneRay* rays, double limit, WideSlabs* out);
    void (*local)(const wide::Frame& frame, const wide::LaneRay* rays, wide::LaneRay* out);
    /// The same, ray by ray, without squares and `filter_error`; and each ray as the tests of the
    /// mesh's boxes use it.
    void (*alone)(const wide::Mesh& mesh, const wide::LaneRay* rays, double limit,
                  wide::LaneRay* out, WideSlabs* slabs);
    /// Rays and a mesh, one by one: the nearest crossings, and whether it hides a light.
    void (*lone_mesh)(const wide::Mesh& mesh, const wide::LaneRay* rays, double limit,
                      WideAnswer* out, WideAnswer* shadow);
    /// The surfaces of eight hits; for unsure ones, `exact` is called.
    void (*surfaces)(const wide::Scene& scene, wide::ExactMethods& exact, const wide::LaneRay* rays,
                     const wide::LaneHit* hits, wide::LaneSurface* out);
    /// Rays bent at a surface with this normal; `t` of the answer is Fresnel's reflectance, `hit`
    /// total reflection.
    void (*bend)(const wide::LaneRay* rays, const double (*normals)[3], const double* ratios,
                 double (*bent)[3], WideAnswer* out);
    void (*power)(const double* x, const double* y, double* out);
    void (*arc_cosine)(const double* x, double* out);
    void (*exponential)(const double* x, double* out);
};

extern const WideKernels wide_kernels_avx2;
extern const WideKernels wide_kernels_avx512;

}  // namespace lancer::oracle
