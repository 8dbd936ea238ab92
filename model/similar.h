// The same scene elsewhere: larger or smaller, moved, with other names for its axes, seen from
// afar. Its picture should be the same; how far it is tells what rounding does to it.
#pragma once

#include "model/scene.h"

namespace lancer {

// In the first three, what stands in world space without a texture gets new numbers, as if written
// so in the script; what has a transform, a texture or parameters of its own (patch, lathe, prism)
// is put under the change, as a group around the whole scene would put it.

/// All lengths times `factor` (> 0): also fade distances, tolerances, an orthographic picture's
/// height; absorption, which is per length, is divided.
Scene scaled(const Scene& scene, double factor);

/// All places plus `by`.
Scene moved(const Scene& scene, const Vec3d& by);

/// x, y, z renamed y, z, x, `times` times over: what lay along x lies along y. Exact.
Scene axes_renamed(const Scene& scene, int times = 1);

/// Every camera `times` (>= 1) as far from what it looks at, with its picture showing as much of
/// that place as before. A perspective camera's angle shrinks; what stood behind it comes into
/// view. An orthographic one is moved back.
Scene seen_from_afar(const Scene& scene, double times);

}  // namespace lancer
