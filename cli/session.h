// The state that all commands share: texts and files of the run, its output, and exceptions that
// end a command early.
#pragma once

#include <exception>
#include <functional>
#include <stdexcept>

#include "cli/exit_codes.h"
#include "cli/run_files.h"
#include "cli/standard_output.h"
#include "cli/terminal.h"
#include "model/source.h"

namespace lancer::cli {

/// Lives as long as the process; main() needs its `sources` to show errors.
struct Session {
    SourceMap sources;
    Terminal terminal;
    StandardOutput output;
    RunFiles files;

    /// Registers a file that the run will write, as RunFiles::add_output does; `-` reserves
    /// standard output.
    void will_write(const std::string& path, const std::string& option);
    /// Writes a result: to standard output when `path` is `-`; nothing when it is empty.
    void write(const std::string& path, const std::string& bytes);
};

/// The command line asks for something impossible: exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The scene, or a value that the command line gives to a param, has errors. They have been shown.
struct SceneRejected : std::exception {
    explicit SceneRejected(ExitCode why) : code(why) {}
    ExitCode code;
};

/// What the command line asks for.
using Action = std::function<ExitCode(Session&)>;

}  // namespace lancer::cli
