// Runs scripts in tests: text in, scene and messages out.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/diagnostic.h"
#include "parser/parse.h"

namespace lancer::test {

struct Result {
    Scene scene;
    std::string messages;  ///< all diagnostics as they are printed
    std::vector<Diagnostic> found;
    std::vector<std::string> printed;
    std::string usage;  ///< messages about -D
};

/// A loader that knows these files and no others. Meshes and images named are one triangle, one
/// pixel: "grey" of one channel, "layers" with more than colour.
inline Loader memory_loader(std::map<std::string, std::string> files) {
    Loader loader;
    loader.text = [files](const std::string& path, std::size_t limit) {
        const auto at = files.find(path);
        if (at == files.end()) throw FileError("cannot read '" + path + "': no such file");
        if (at->second.size() > limit) throw FileError("'" + path + "' is too long");
        return at->second;
    };
    loader.mesh = [](const std::string& path) {
        if (path.find("missing") != std::string::npos)
            throw FileError("cannot read '" + path + "'");
        io::LoadedMesh loaded;
        loaded.mesh.vertices = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)};
        loaded.mesh.faces = {{0, 1, 2}};
        return loaded;
    };
    loader.image = [](const std::string& path, io::ColorSpace) {
        if (path.find("missing") != std::string::npos)
            throw FileError("cannot read '" + path + "'");
        if (path.find("grey") != std::string::npos) return Image(1, 1, 1);
        if (path.find("layers") != std::string::npos) {
            Image image(1, 1, 5);  // its fourth channel is no alpha
            image.extra_names = {"depth.Z", "normal.X"};
            return image;
        }
        return Image(1, 1);
    };
    return loader;
}

/// Runs `text` as the script main.lancer.
inline Result run(const std::string& text, const Definitions& definitions = {},
                  const std::map<std::string, std::string>& files = {}, const Limits& limits = {}) {
    Result result;
    SourceMap sources;
    const Script script = parse_script("main.lancer", text, limits, sources, result.found);
    Evaluation evaluation =
        evaluate(script, definitions, limits, sources, result.found, memory_loader(files));
    for (const Diagnostic& d : result.found) result.messages += format(d, sources);
    for (const Diagnostic& d : evaluation.usage_errors) result.usage += format(d, sources);
    result.scene = std::move(evaluation.scene);
    result.printed = std::move(evaluation.printed);
    return result;
}

/// What `print` says about an expression; the messages if there are any.
inline std::string value_of(const std::string& expression) {
    const Result result = run("print " + expression + "\n");
    return result.messages.empty() ? result.printed.at(0) : result.messages;
}

}  // namespace lancer::test
