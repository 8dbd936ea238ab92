// Causes in how the other program read the scene: found by rendering the scene that way.
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
    bool mirrored = false;  ///< also exchanges left and right
};

/// Variants of the camera, of the settings, and of the `suspects`, the objects that many different
/// pixels show: their normals, and whether they exist; then of all objects of one kind, and of all
/// materials. The simplest come first. `camera` is an index into Scene::cameras.
std::vector<SceneVariant> scene_variants(const ValidationJob& job, std::size_t camera,
                                         const std::vector<std::size_t>& suspects);

// Groups of them, each in a file of its own.

/// Normals and absence: of the suspects, of all objects of one kind, of all objects.
void add_object_variants(std::vector<SceneVariant>& variants, const ValidationJob& job,
                         const std::vector<std::size_t>& suspects);
/// Highlights, mirrors and glass: terms that are missing or have another parameter.
void add_material_variants(std::vector<SceneVariant>& variants, const Scene& scene);
/// Images that are flipped or decoded differently, colours through a curve.
void add_texture_variants(std::vector<SceneVariant>& variants, const Scene& scene);

}  // namespace lancer::judge
