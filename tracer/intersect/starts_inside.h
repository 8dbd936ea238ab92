// Which bodies a camera ray begins in.
#pragma once

#include <cstdint>

#include "tracer/rays/ray.h"
#include "tracer/scene/geometry.h"

namespace lancer {

/// Whether the ray's origin lies in the body. An origin on its surface belongs to the side that the
/// ray goes to.
template <class Real>
bool starts_inside(const Geometry<Real>& geometry, std::uint32_t index, const Ray<Real>& ray);

}  // namespace lancer
