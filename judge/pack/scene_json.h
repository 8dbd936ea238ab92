// A scene as neutral data.
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

#include "judge/pack/pack.h"
#include "model/bodies.h"
#include "model/scene.h"

namespace lancer::judge {

using Json = nlohmann::ordered_json;

inline Json to_json(const Vec3d& v) {
    return {v.x, v.y, v.z};
}
inline Json to_json(const Vec2d& v) {
    return {v.x, v.y};
}

/// Collects the files that a scene's data refer to. Knows which objects are bodies, and the places
/// of objects in the script.
struct PackSink {
    PackSink(const Scene& scene, std::function<std::string(const SourceSpan&)> places)
        : bodies(scene), place_text(std::move(places)) {}

    std::vector<PackedFile> files;
    Bodies bodies;
    std::function<std::string(const SourceSpan&)> place_text;  ///< may be empty
};

/// {"kind": "sphere", "center": [...], ...}: the pack's README describes each kind. Meshes become
/// files.
Json shape_json(const Scene& scene, const Object& object, PackSink& sink);
Json object_json(const Scene& scene, const Object& object, PackSink& sink);

/// Everything except pictures and probes: camera, lights, materials, textures, images, objects.
Json scene_json(const Scene& scene, std::size_t camera, PackSink& sink);

}  // namespace lancer::judge
