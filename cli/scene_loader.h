// Loads a scene file: reads and parses it once, and evaluates it once per frame.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/session.h"
#include "model/scene.h"
#include "parser/parse.h"

namespace CLI {
class App;
}

namespace lancer::cli {

/// The options of every command that reads a scene.
struct SceneOptions {
    std::vector<std::pair<std::string, std::string>> definitions;  ///< -D name=value
    Limits limits;
};
void add_scene_options(CLI::App& app, SceneOptions& options);

class SceneLoader {
  public:
    /// Reads the file at `path` (`-`: standard input). Throws FileError, and UsageError when an
    /// output of the run would replace it. Shows no diagnostics yet. `threads` read large meshes
    /// (0: as many as the machine has).
    SceneLoader(const std::string& path, const SceneOptions& options, Session& session,
                int threads = 0);

    /// The scene of one frame. Shows the output of `print`, and every diagnostic that was not shown
    /// before. Throws SceneRejected when there are errors, and UsageError when -D names an unknown
    /// param or when an output of the run would replace a file that the scene reads.
    Scene load(std::optional<double> frame = {}, std::optional<double> time = {});

    /// The same for the last scene: no load() may follow. Frees the script's syntax: where a long
    /// script declares many small objects, it takes more memory than the scene.
    Scene load_last(std::optional<double> frame, std::optional<double> time);

    /// What load() shows of a scene without mistakes, beside its own diagnostics and counted with
    /// them.
    void show_too(std::function<std::vector<Diagnostic>(const Scene&)> hints) {
        hints_ = std::move(hints);
    }

    /// Digest of the definitions and of the contents of all files that were read for the scenes
    /// loaded so far; file names do not count. Equal digests mean equal scenes. To be called after
    /// load(), which reads each file once: the bytes of that moment count. Throws FileError.
    std::string content();

    /// Digest of what `scene`, a result of load(), shows: equal for scenes that are equal although
    /// their scripts differ. Images count by the contents of their files, which are read once more.
    /// Throws FileError.
    std::string digest_of(const Scene& scene);

    double parse_seconds() const { return parse_seconds_; }
    /// Total of all evaluations so far.
    double evaluate_seconds() const { return evaluate_seconds_; }

  private:
    const std::string& file_digest(const std::string& path);
    void show_new(std::vector<Diagnostic> found);

    SceneOptions options_;
    Session& session_;
    std::function<std::vector<Diagnostic>(const Scene&)> hints_;
    int threads_;
    Script script_;
    std::vector<Diagnostic> syntax_errors_;
    /// digests of the other files that were read, by path
    std::map<std::string, std::string> read_;
    /// shown warnings, so that ten frames do not repeat them ten times
    std::set<std::string> shown_;
    double parse_seconds_ = 0;
    double evaluate_seconds_ = 0;
};

/// The index of the camera with this name; the first camera for an empty name. Throws UsageError
/// when there is no such camera. Without any camera, shows that error and throws SceneRejected.
std::size_t pick_camera(const Scene& scene, const std::string& name, const Session& session);

/// Warnings about a scene that is valid but seldom meant: no camera, no light.
std::vector<Diagnostic> missing_parts(const Scene& scene);

}  // namespace lancer::cli
