// Signals. Ctrl-C ends the process at once and leaves no partial file. A broken output is an error
// like any other.
#pragma once

namespace lancer::cli {

/// From now on SIGINT and SIGTERM end the process with exit code 130 or 143. Temporary files and
/// folders are removed; a file that has its final name is complete.
void end_on_interrupt();

/// From now on, writing into a closed pipe or beyond the largest allowed file size is an error of
/// that write and does not end the process.
void keep_on_broken_output();

/// Opens standard input, output and error if the caller has closed them, so that no file of the run
/// gets their numbers. Reading or writing them then fails.
void open_missing_streams();

}  // namespace lancer::cli
