// The exit codes of the process.
#pragma once

namespace lancer::cli {

enum class ExitCode {
    done = 0,
    differs = 1,     ///< images differ, or a check failed
    usage = 2,       ///< wrong use of the command line
    scene = 3,       ///< the scene has errors
    files = 4,       ///< a file cannot be read or written; POV-Ray is missing or failed
    bug = 70,        ///< the program's own fault, as sysexits.h numbers it
    try_again = 75,  ///< missing parts, a network: trying again may help, as sysexits.h numbers it
    interrupted = 130  ///< by SIGINT, as shells number it
};

}  // namespace lancer::cli
