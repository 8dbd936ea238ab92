// Judges the scenes of `lancer validate` in parallel.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cli/against_options.h"
#include "cli/exit_codes.h"
#include "cli/progress.h"
#include "cli/scene_loader.h"
#include "cli/scene_size.h"
#include "cli/session.h"
#include "cli/sweep_share.h"
#include "judge/validate/validate.h"

namespace lancer::cli {

/// The options of the command.
struct ValidateJob {
    std::vector<std::string> scenes;
    std::string report;
    std::string json;
    std::string junit;
    std::string camera;
    std::optional<PartOf> part;  ///< of the scenes
    std::optional<PictureSize> size;
    std::optional<std::int64_t> jobs;
    std::optional<double> time_limit;
    bool no_cache = false;
    bool quiet = false;
    AgainstOptions against;
    SceneOptions scene_options;
};

/// Judges a scene; a failure becomes a verdict. Called from several threads.
using Judge = std::function<judge::Validation(const judge::ValidationJob& job)>;

/// The other renderer.
struct OtherSide {
    std::string name;            ///< the heading of the column with its times
    std::string povray_version;  ///< empty: it is not POV-Ray
    judge::Report report;        ///< without entries
    Judge judge;
};

/// Validates all jobs, as many in parallel as `options` says. Prints each line as soon as it is
/// known, in the order of the jobs, and collects the entries of the report.
class Validations {
  public:
    Validations(const ValidateJob& options, std::vector<judge::ValidationJob> jobs, OtherSide other,
                Session& session);

    void run();
    /// Writes the requested files.
    ExitCode finish();

  private:
    void show_progress(std::size_t job, double share, const char* what);
    void validate(std::size_t i);
    void show_lines();

    const ValidateJob& options_;
    Session& session_;
    std::vector<judge::ValidationJob> jobs_;
    OtherSide other_;
    std::size_t name_width_ = 5;
    std::mutex mutex_;
    std::vector<judge::Validation> results_;
    std::vector<bool> done_;
    std::size_t shown_ = 0;
    std::vector<double> shares_;  ///< of each job that is done
    ProgressBar bar_;
};

}  // namespace lancer::cli
