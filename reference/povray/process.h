// Runs another program: without a shell, in its own process group, with a time limit.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lancer::reference {

struct ProcessResult {
    bool timed_out = false;  ///< it and whatever it had started were killed
    int exit_code = 0;       ///< 128 + n when signal n ended it; 127 when it could not be started
    std::string messages;    ///< stdout and stderr as they came, the first MiB
    double seconds = 0;      ///< wall clock
};

/// Runs `command` (the program's path, then its arguments) in `folder`, with HOME set to `folder`
/// and an empty standard input. The program dies when this process does. Thread-safe. Throws
/// FileError when the system cannot create a process or a file.
ProcessResult run_process(const std::vector<std::string>& command,
                          const std::filesystem::path& folder, double time_limit_seconds);

}  // namespace lancer::reference
