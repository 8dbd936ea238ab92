// The command line as CLI11 knows it. main() parses it; help and manual pages are made from it.
#pragma once

#include "cli/session.h"

namespace CLI {
class App;
}

namespace lancer::cli {

/// Adds all commands and the description of the program. After a command line has been parsed,
/// `action` is what to do.
void set_up_command_line(CLI::App& app, Action& action);

}  // namespace lancer::cli
