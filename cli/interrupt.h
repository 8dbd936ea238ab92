// Signals: Ctrl-C ends the process at once and leaves no half file; an output that breaks is an
// error like any other.
#pragma once

namespace lancer::cli {

/// From now on SIGINT and SIGTERM end the process with exit code 130 (143). Temporary files and
/// folders are removed; a file that is already renamed is whole.
void end_on_interrupt();

/// From now on writing into a closed pipe, or beyond the largest file allowed, is an error of that
/// write instead of the end of the process.
void keep_on_broken_output();

/// Opens standard input, output and error where the caller has closed them, so that no file of the
/// run takes their place. Using them fails then.
void open_missing_streams();

}  // namespace lancer::cli
