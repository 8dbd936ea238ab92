// The exit codes of the process.
#pragma once

namespace lancer::cli {

enum class ExitCode {
    done = 0,
    differs = 1,       ///< images differ, or a check failed
    usage = 2,         ///< wrong use of the command line
    scene = 3,         ///< the scene has errors
    files = 4,         ///< a file cannot be read or written; POV-Ray is missing or failed
    bug = 70,          ///< an error of the program itself; the number is from sysexits.h
    try_again = 75,    ///< missing parts, a network: trying again may help (number from sysexits.h)
    interrupted = 130  ///< by SIGINT, as shells number it
};

}  // namespace lancer::cli
