// The scene that a pack contains.
#pragma once

#include <vector>

#include "model/diagnostic.h"
#include "model/scene.h"

namespace lancer::judge {

/// A scene whose picture needs no settings: if they switch off textures, its materials have plain
/// colours; if they switch off smooth normals, it has none. All surfaces are exact; each that had a
/// tolerance causes a warning.
Scene as_packed(const Scene& scene, std::vector<Diagnostic>& warnings);

/// Rounds the scene's images to the floats of a pack's files, so that its probes use the reader's
/// values.
void round_images(Scene& scene);

}  // namespace lancer::judge
