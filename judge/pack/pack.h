// The data with which another renderer can test itself on a scene: the scene as neutral data, the
// picture and its other channels as floats, and exact values for chosen pixels, each with its
// error.
#pragma once

#include <string>
#include <vector>

#include "judge/validate/validate.h"

namespace lancer::judge {

/// How many pixels get exact values.
inline constexpr std::size_t default_probes = 32;

struct PackedFile {
    std::string name;  ///< within the scene's folder
    std::string bytes;
};

struct Pack {
    /// Where the pack differs from the scene, with places: surfaces with a tolerance become exact
    /// surfaces in a pack.
    std::vector<Diagnostic> warnings;
    std::vector<PackedFile> files;
    std::size_t undecided = 0;  ///< pixels that depend on the last digits
    std::size_t probes = 0;
};

/// Packs what `job` shows under render { textures false, smooth false }, as far as the scene says
/// so: one ray through the centre of each pixel, no branch left out. The scene must have been
/// prepared for that, see prepare_for_validation(). Throws SceneError.
Pack pack_scene(const ValidationJob& job, std::size_t probes);

/// The page that explains the format, in Markdown.
std::string pack_readme();

/// pack.json, which lists the scenes' folders and marks the folder as a pack.
std::string pack_index(const std::vector<std::string>& names, const std::string& lancer_version);

/// Whether the text is that of a pack.json.
bool is_pack_index(const std::string& text);

}  // namespace lancer::judge
