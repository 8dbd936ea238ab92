// Tachyon (Debian: tachyon-bin-nox), a ray tracer without refraction and cones, to compare with.
#pragma once

#include <optional>
#include <string>

#include "model/image.h"
#include "model/scene.h"

namespace lancer::bench {

/// The scene in Tachyon's words. What it has no word for is left out: cones, glass, splines,
/// whatever stands under a transform; so a picture can be compared with Tachyon's own alone.
std::string tachyon_scene(const Scene& scene);

/// Its picture of the scene's first camera, 16 bits; nothing when it failed. Its samples lie half a
/// pixel from ours.
std::optional<Image> run_tachyon(const std::string& program, const Scene& scene);

/// The program in PATH; empty where there is none.
std::string find_tachyon();

}  // namespace lancer::bench
