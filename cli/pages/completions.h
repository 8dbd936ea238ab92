// Shell scripts that complete commands, options and their values.
#pragma once

#include <string>

#include "cli/command_table.h"

namespace lancer::cli {

/// For bash 4 and newer; does not need the package bash-completion.
std::string bash_completion(const CommandTable& table);
std::string zsh_completion(const CommandTable& table);
std::string fish_completion(const CommandTable& table);

}  // namespace lancer::cli
