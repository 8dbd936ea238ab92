// The same scene, scaled, moved, with its axes renamed, or seen from far away. Its picture should
// not change; any change is caused by rounding.
#pragma once

#include "model/scene.h"

namespace lancer {

// In the first three functions, objects in world space without a texture get new numbers, as if the
// script had them. Objects with a transform, a texture or their own parameters (patch, lathe,
// prism) get a transform, as in a group around the whole scene.

/// Multiplies all lengths by `factor` (> 0), including fade distances, tolerances and the height of
/// an orthographic picture. Absorption is per length, so it is divided.
Scene scaled(const Scene& scene, double factor);

/// Moves everything by `by`.
Scene moved(const Scene& scene, const Vec3d& by);

/// Renames x, y, z to y, z, x, `times` times: what was along x is along y. Exact.
Scene axes_renamed(const Scene& scene, int times = 1);

/// Moves every camera to `times` (>= 1) its distance from its look_at point, with the same extent
/// of that place in its picture. The angle of a perspective camera shrinks; objects behind it come
/// into view. An orthographic camera is moved back.
Scene seen_from_afar(const Scene& scene, double times);

}  // namespace lancer
