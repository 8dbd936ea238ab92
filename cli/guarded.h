// Turns every failure of a run into a message and an exit code.
#pragma once

#include <functional>

#include "cli/session.h"

namespace lancer::cli {

/// Returns the exit code of `run`, or of the exception that it throws, which is shown on standard
/// error. Afterwards standard output is complete; if it could not be written, the exit code is that
/// of files.
ExitCode guarded(Session& session, const std::function<ExitCode()>& run);

}  // namespace lancer::cli
