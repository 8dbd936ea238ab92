// Causes that lie in how the other program read the scene: found by rendering it so.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "judge/validate/validate.h"

namespace lancer::judge {

/// The scene as another program may have understood it.
struct SceneVariant {
    std::string words;  ///< a sentence without a full stop
    std::function<void(Scene&)> change;
    bool mirrored = false;  ///< left and right are exchanged besides
};

/// Variants of the camera, of the settings, and of the `suspects`, objects of which many pixels
/// differ: their normals, whether they are there at all; then of all objects of a kind, and of all
/// materials. The plainest first. `camera` is an index into the scene's.
std::vector<SceneVariant> scene_variants(const ValidationJob& job, std::size_t camera,
                                         const std::vector<std::size_t>& suspects);

// Parts of them, in files of their own.

/// Normals and absence: of the suspects, of all objects of a kind, of all.
void add_object_variants(std::vector<SceneVariant>& variants, const ValidationJob& job,
                         const std::vector<std::size_t>& suspects);
/// Highlights, mirrors, glass: terms that are left out or have another parameter.
void add_material_variants(std::vector<SceneVariant>& variants, const Scene& scene);
/// Images turned over or read otherwise, colours through a curve.
void add_texture_variants(std::vector<SceneVariant>& variants, const Scene& scene);

}  // namespace lancer::judge
