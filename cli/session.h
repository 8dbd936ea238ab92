// What all commands share: the texts and files of the run, where words go, and how a command ends
// early.
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

/// Lives as long as the process; errors that surface in main() are shown with its `sources`.
struct Session {
    SourceMap sources;
    Terminal terminal;
    StandardOutput output;
    RunFiles files;

    /// A file that the run will write, as RunFiles::add_output has it; `-` claims standard output.
    void will_write(const std::string& path, const std::string& option);
    /// Writes a result: to standard output when `path` is `-`, and not at all when it is empty.
    void write(const std::string& path, const std::string& bytes);
};

/// The command line asks for something that is not to be had: exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The scene, or a value that the command line gives to one of its params, has errors, and they
/// have been shown.
struct SceneRejected : std::exception {
    explicit SceneRejected(ExitCode why) : code(why) {}
    ExitCode code;
};

/// What the command line asks for.
using Action = std::function<ExitCode(Session&)>;

}  // namespace lancer::cli
