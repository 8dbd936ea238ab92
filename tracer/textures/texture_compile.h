// Scene → the tracer's textures.
#pragma once

#include "tracer/world.h"

namespace lancer {

/// Adds all textures of the scene to world.textures, and keeps their images alive.
template <class Real>
void compile_textures(const Scene& scene, World<Real>& world);

/// Where the object's texture lies on its primitive.
///
/// \param own  a primitive with a frame has its own coordinates scaled by 2^own
template <class Real>
TextureSeat<Real> seat_texture(const Scene& scene, const World<Real>& world, const Object& object,
                               const Primitive<Real>& primitive, int own);

}  // namespace lancer
