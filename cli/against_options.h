// The options by which `validate` judges other renderers' pictures.
#pragma once

#include <string>
#include <vector>

#include "judge/against/against.h"

namespace CLI {
class App;
}

namespace lancer::cli {

struct AgainstOptions {
    std::string pictures;  ///< a file, or a folder with a file for each scene; empty: POV-Ray
    judge::Reading reading;
    bool reading_is_given = false;

    bool asked() const { return !pictures.empty(); }
};

void add_against_options(CLI::App& app, AgainstOptions& options);

/// The picture for `scene`, one of a number of `scenes`. Throws UsageError when one file is given
/// for several scenes, and FileError when a folder has no picture for this scene.
std::string picture_for(const AgainstOptions& options, const std::string& scene,
                        std::size_t scenes);

}  // namespace lancer::cli
