#include "cli/command_line.h"

#include <CLI/CLI.hpp>

#include "cli/commands.h"
#include "cli/help_words.h"

namespace lancer::cli {

void set_up_command_line(CLI::App& app, Action& action) {
    app.name("lancer");
    app.description("Lancer: a small scene language and the ray tracer that renders it");
    app.require_subcommand(1);
    app.get_formatter()->column_width(30);
    add_render(app, action);
    add_join(app, action);
    add_check(app, action);
    add_info(app, action);
    add_export(app, action);
    add_compare(app, action);
    add_pack(app, action);
    add_validate(app, action);
    add_stability(app, action);
    add_tradeoff(app, action);
    add_probe(app, action);
    app.footer(general_help());
    app.set_version_flag("--version", "lancer " LANCER_VERSION);
    for (CLI::App* command : app.get_subcommands({}))
        command->set_version_flag("--version", "lancer " LANCER_VERSION);
}

}  // namespace lancer::cli
