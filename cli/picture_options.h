// How much the work on one picture file may cost.
#pragma once

namespace CLI {
class App;
}

namespace lancer::cli {

/// For every command that reads or writes pictures. What stands on the command line holds from the
/// moment it is read.
void add_picture_options(CLI::App& app);

}  // namespace lancer::cli
