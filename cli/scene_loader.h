// A scene file on its way to a Scene: read and parsed once, evaluated once per frame.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
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
    /// output of the run would be written over it. Nothing is shown yet.
    SceneLoader(const std::string& path, const SceneOptions& options, Session& session);

    /// The scene of one frame, as the script has it. Shows what `print` says, and every diagnostic
    /// that has not been shown before. Throws SceneRejected when there are errors, and UsageError
    /// when -D names a param that is not there, or when an output of the run would be written over
    /// a file that the scene reads.
    Scene load(std::optional<double> frame = {}, std::optional<double> time = {});

    /// Digest of all that was read for the scenes loaded so far, names not counted, and of the
    /// definitions: equal ones make equal scenes. After load(), which reads each file once: its
    /// bytes count as they were then. Throws FileError.
    std::string content();

    /// Digest of what this scene, which load() gave, shows: scenes that a changed script makes
    /// alike have the same. Images count by their files, which each are read once more. Throws
    /// FileError.
    std::string digest_of(const Scene& scene);

    double parse_seconds() const { return parse_seconds_; }
    /// Of all evaluations up to now.
    double evaluate_seconds() const { return evaluate_seconds_; }

  private:
    const std::string& file_digest(const std::string& path);
    void show_new(std::vector<Diagnostic> found);

    SceneOptions options_;
    Session& session_;
    Script script_;
    std::vector<Diagnostic> syntax_errors_;
    std::map<std::string, std::string> read_;  ///< files beside the script's own, their digests
    std::set<std::string> shown_;  ///< warnings, so that ten frames do not warn ten times
    double parse_seconds_ = 0;
    double evaluate_seconds_ = 0;
};

/// The camera of this name, the first for an empty name. Throws UsageError when no camera is called
/// so; without any camera shows that error and throws SceneRejected.
std::size_t pick_camera(const Scene& scene, const std::string& name, const Session& session);

/// What is not wrong but seldom meant: no camera, no light.
std::vector<Diagnostic> missing_parts(const Scene& scene);

}  // namespace lancer::cli
