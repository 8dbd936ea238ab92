// Colours that vary over a surface.
#pragma once

#include "tracer/world.h"

namespace lancer {

template <class Real>
struct Surface;

template <class Real>
struct TextureColor {
    Vec3<Real> color{1};
    bool has_alpha = false;  ///< `alpha` replaces the material's filter and transmission
    Real alpha = 1;
};

/// The colour of texture `texture` at a point of a primitive, given in the primitive's own space.
template <class Real>
TextureColor<Real> texture_color(const World<Real>& world, std::uint32_t texture,
                                 const Primitive<Real>& primitive, const SurfacePoint<Real>& local,
                                 const Surface<Real>& surface) {
    (void)world, (void)texture, (void)primitive, (void)local, (void)surface;
    return {};
}

}  // namespace lancer
