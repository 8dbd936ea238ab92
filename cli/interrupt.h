// Ctrl-C: ends the process at once and leaves no half file.
#pragma once

namespace lancer::cli {

/// From now on SIGINT and SIGTERM end the process with exit code 130 (143). Temporary files and
/// folders are removed; a file that is already renamed is whole.
void end_on_interrupt();

}  // namespace lancer::cli
