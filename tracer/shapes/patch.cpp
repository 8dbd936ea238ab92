#include "tracer/shapes/patch.h"

#include <cmath>

#include "tracer/mesh_compile.h"
#include "tracer/splines/tessellate.h"

namespace lancer {

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
        bounds_.extend(convert<Real>(Vec3d(std::ldexp(p.x, exponent), std::ldexp(p.y, exponent),
                                           std::ldexp(p.z, exponent))));
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

template class PatchSurface<float>;
template class PatchSurface<double>;
template class PatchSurface<long double>;

}  // namespace lancer
