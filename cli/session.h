// What all commands share: the texts read, the terminal, and how a command ends early.
#pragma once

#include <exception>
#include <functional>
#include <stdexcept>

#include "cli/exit_codes.h"
#include "cli/terminal.h"
#include "model/source.h"

namespace lancer::cli {

/// Lives as long as the process; errors that surface in main() are shown with its `sources`.
struct Session {
    SourceMap sources;
    Terminal terminal;
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
