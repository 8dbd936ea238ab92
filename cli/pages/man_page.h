// Manual pages of section 1: one for the program, one for each command.
#pragma once

#include <string>

#include "cli/command_table.h"

namespace lancer::cli {

/// `date` is YYYY-MM-DD.
std::string program_page(const CommandTable& table, const std::string& date);
std::string command_page(const CommandTable& table, const CommandRow& command,
                         const std::string& date);

}  // namespace lancer::cli
