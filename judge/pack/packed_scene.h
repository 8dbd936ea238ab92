// The scene that a pack holds.
#pragma once

#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"

namespace lancer::judge {

/// A scene that needs no settings to say what it shows: where they leave out textures, materials
/// have their plain colours, and where they leave out smooth normals there are none. Surfaces are
/// true ones; each that asked for a tolerance is a warning.
Scene as_packed(const Scene& scene, std::vector<Diagnostic>& warnings);

/// Gives the scene's images the numbers that a pack's files hold, floats: so its probes are of
/// what the reader has.
void round_images(Scene& scene);

}  // namespace lancer::judge
