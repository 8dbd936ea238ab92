// Everything that can go wrong in a run ends here, as a message and an exit code.
#pragma once

#include <functional>

#include "cli/session.h"

namespace lancer::cli {

/// The exit code of `run`, or of what it throws, which is told on standard error. Standard output
/// is complete afterwards, or the exit code is that of files.
ExitCode guarded(Session& session, const std::function<ExitCode()>& run);

}  // namespace lancer::cli
