// Patches with a tolerance: triangles replace the surface. They are made when the first ray comes
// near it. For patches without a tolerance see tracer/shapes/bicubic.h.
#pragma once

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include "model/shapes.h"
#include "tracer/rays/bounds.h"
#include "tracer/rays/crossing.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/mesh.h"
#include "tracer/shapes/mesh_build.h"
#include "tracer/shapes/traits.h"
#include "tracer/tessellation/tessellate.h"

namespace lancer {

/// A patch or net of the scene with its tolerance. It is tessellated when the first ray comes near
/// it. The result does not depend on which ray that is.
template <class Real>
class PatchSurface {
  public:
    /// \param tolerance  in the patch's own space; see splines::tessellate()
    /// \param borders    must outlive this object; may be null
    /// \param exponent   its triangles are those of the patch times 2^exponent
    PatchSurface(Patch patch, std::optional<double> tolerance,
                 const splines::BorderTolerances* borders, int exponent, bool smooth);

    /// Safe from many threads: one builds, the others wait.
    const TriangleMesh<Real>& mesh() const {
        const TriangleMesh<Real>* ready = ready_.load(std::memory_order_acquire);
        return ready != nullptr ? *ready : build();
    }
    /// The mesh if it exists already, else null.
    const TriangleMesh<Real>* built() const { return ready_.load(std::memory_order_acquire); }

    /// The bounds of the control points, and so of the surface and its triangles.
    const Bounds<Real>& bounds() const { return bounds_; }

  private:
    const TriangleMesh<Real>& build() const;

    Patch patch_;
    std::optional<double> tolerance_;
    const splines::BorderTolerances* borders_;
    int exponent_;
    bool smooth_;
    Bounds<Real> bounds_;
    mutable std::mutex building_;
    mutable std::unique_ptr<const TriangleMesh<Real>> mesh_;
    mutable std::atomic<const TriangleMesh<Real>*> ready_{nullptr};
};

template <class Real>
PatchSurface<Real>::PatchSurface(Patch patch, std::optional<double> tolerance,
                                 const splines::BorderTolerances* borders, int exponent,
                                 bool smooth)
    : patch_(std::move(patch)),
      tolerance_(tolerance),
      borders_(borders),
      exponent_(exponent),
      smooth_(smooth) {
    for (const Vec3d& p : patch_.control) {
        bounds_.extend(
            convert<Real>(Vec3d(ldexp(p.x, exponent), ldexp(p.y, exponent), ldexp(p.z, exponent))));
    }
}

template <class Real>
const TriangleMesh<Real>& PatchSurface<Real>::build() const {
    const std::lock_guard lock(building_);
    if (mesh_ == nullptr) {
        auto mesh =
            std::make_shared<const Mesh>(splines::tessellate(patch_, tolerance_, borders_).value());
        mesh_ = compile_mesh<Real>(std::move(mesh), exponent_, MeshNeeds{smooth_, false}, 1);
        ready_.store(mesh_.get(), std::memory_order_release);
    }
    return *mesh_;
}

/// One instance of a patch. Its faces are those of its mesh.
template <class Real>
struct PatchSolid {
    const PatchSurface<Real>* surface;
    bool smooth;

    MeshInstance<Real> instance() const { return {&surface->mesh(), smooth}; }

    static constexpr SolidTraits traits{.convex = false, .face_by_face = true};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

template <class Real, class Last, class Report>
void crossings(const PatchSolid<Real>& patch, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    crossings(patch.instance(), ray, hints, interval, report);
}

/// The point at the barycentric coordinates u, v of a face, with the surface's parameters, which
/// are linear within the triangle.
template <class Real>
SurfacePoint<Real> patch_point(const PatchSolid<Real>& patch, std::uint32_t face, Real u, Real v) {
    const MeshInstance<Real> instance = patch.instance();
    const Mesh& mesh = *instance.mesh->source;
    SurfacePoint<Real> p = triangle_point(instance.mesh->triangle(face), u, v);
    p.shading = shading_normal(instance, face, u, v, p.normal);
    const auto at = [&](std::size_t i) {
        const Vec2d& uv = mesh.uvs[mesh.faces[face][i]];
        return Vec2<Real>(static_cast<Real>(uv.x), static_cast<Real>(uv.y));
    };
    p.parameter = (1 - u - v) * at(0) + u * at(1) + v * at(2);
    return p;
}

}  // namespace lancer
