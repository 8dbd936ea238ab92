// The valid scenes of the collection, one after the other.
#pragma once

#include <filesystem>
#include <string>

#include "cli/scene_loader.h"

namespace lancer {

/// Calls visit(scene, path) for each, with one sample a pixel. \return how many there were
template <class Visit>
int for_each_scene(Visit&& visit) {
    int scenes = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(LANCER_SOURCE_DIR "/scenes")) {
        const std::string path = entry.path().string();
        if (entry.path().extension() != ".lancer" || path.find("/bad/") != std::string::npos)
            continue;
        cli::Session session;
        Scene scene = cli::SceneLoader(path, {}, session).load();
        scene.settings.samples = 1;
        visit(scene, path);
        ++scenes;
    }
    return scenes;
}

}  // namespace lancer
