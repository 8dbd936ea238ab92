// The commands, one file each. Each function adds its command to the command line. When that
// command was given, `action` is what to do.
#pragma once

#include "cli/session.h"

namespace CLI {
class App;
}

namespace lancer::cli {

void add_render(CLI::App& app, Action& action);
void add_join(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_pack(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_stability(CLI::App& app, Action& action);
void add_tradeoff(CLI::App& app, Action& action);
void add_probe(CLI::App& app, Action& action);

}  // namespace lancer::cli
