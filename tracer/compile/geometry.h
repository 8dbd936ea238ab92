// Compiles the shapes of a scene: primitives, trees, and where textures lie on them.
#pragma once

#include "model/requirements.h"
#include "model/scene.h"
#include "tracer/scene/geometry.h"
#include "tracer/scene/povray_rules.h"

namespace lancer {

/// Fills the geometry, the `scale_exponent` of which is set. Throws SceneError, with the place in
/// the script, if a coordinate leaves the number type's range.
///
/// \param by_povray  POV-Ray's rules, by which shapes are then drawn; may be null
template <class Real>
void compile_geometry(const Scene& scene, const Settings& settings,
                      const Requirements& requirements, const PovRayRules* by_povray,
                      Geometry<Real>& geometry);

}  // namespace lancer
