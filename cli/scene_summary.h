// For `info`: counts the contents of a scene, and lists the features that it requires.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/requirements.h"
#include "model/scene.h"

namespace lancer::cli {

/// A kind of object and the number of its instances.
struct Count {
    std::string_view kind;
    std::uint64_t number = 0;
};

/// A required feature, and the first object that asks for it.
struct Requirement {
    Feature feature{};
    std::string by;     ///< `sphere "ball", material glass`
    std::string place;  ///< `file:line:column`
};

struct SceneSummary {
    std::vector<Count>
        shapes;  ///< in the order of the language; kinds that do not occur are left out
    std::vector<Count> lights;
    std::uint64_t triangles = 0;  ///< of single triangles, and of meshes for each of their uses
    std::uint64_t meshes = 0;     ///< stored meshes, whatever the number of their uses
    std::uint64_t materials = 0;  ///< in use
    std::uint64_t textures = 0;
    std::uint64_t images = 0;
    std::vector<Requirement> requirements;
};

SceneSummary summarize(const Scene& scene, const SourceMap& sources);

std::uint64_t total(const std::vector<Count>& counts);

}  // namespace lancer::cli
