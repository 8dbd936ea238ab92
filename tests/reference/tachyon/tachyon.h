// Tachyon (Debian: tachyon), a ray tracer without refraction and cones, for comparisons.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/image.h"
#include "model/scene.h"

namespace lancer {

/// A scene in Tachyon's language.
struct TachyonScene {
    std::string text;
    /// The number of objects and lights that Tachyon cannot express, and the sky: cones, glass,
    /// splines, spot lights and everything under a transform are missing; a textured object has its
    /// plain colour.
    std::size_t not_said = 0;
};

/// The first camera's view. Tachyon's space is left-handed: it gets the mirror image of the scene,
/// and its picture is equal to ours.
TachyonScene tachyon_scene(const Scene& scene);

/// The program in PATH; empty where there is none.
std::string find_tachyon();

/// Renders with Phong highlights into FOLDER/scene.ppm, in one of Tachyon's kinds of PPM:
/// PPM48 has 16 bits a channel, linear light, PPM has 8. The file's path; nothing when it failed.
std::optional<std::string> run_tachyon(const std::string& program, const Scene& scene,
                                       const std::filesystem::path& folder,
                                       const std::string& format = "PPM48");

/// Its picture of the scene; nothing when it failed. Its rays go through the pixels' upper right
/// corners.
std::optional<Image> tachyon_picture(const std::string& program, const Scene& scene);

}  // namespace lancer
