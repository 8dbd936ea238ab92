// The command line as CLI11 knows it: what main() parses, and what help and pages are made of.
#pragma once

#include "cli/session.h"

namespace CLI {
class App;
}

namespace lancer::cli {

/// Adds all commands and what is said about the program as a whole. Once a command line has been
/// parsed, `action` is what to do.
void set_up_command_line(CLI::App& app, Action& action);

}  // namespace lancer::cli
