// The commands and options as plain data, read from the tables that `--help` shows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lancer::cli {

/// The kind of an option's value, as far as a shell can complete it.
enum class ValueKind : std::uint8_t {
    free,    ///< a number, a name: nothing to complete
    words,   ///< `OptionRow::words`
    file,    ///< any file
    scene,   ///< a file called *.lancer
    folder,  ///< a folder
};

struct OptionRow {
    std::vector<std::string> names;  ///< `-o`, `--output`
    std::string value;  ///< its name in the help, `OUT`; empty: the option takes no value
    ValueKind kind = ValueKind::free;
    std::vector<std::string> words;  ///< the possible values
    std::string meaning;
    std::string group;
    bool is_required = false;
    bool may_repeat = false;
};

struct ArgumentRow {
    std::string name;
    ValueKind kind = ValueKind::free;
    std::string meaning;
    bool may_repeat = false;
};

struct CommandRow {
    std::string name;
    std::string meaning;
    std::vector<ArgumentRow> arguments;  ///< all are required
    std::vector<OptionRow> options;      ///< group by group, in the order of help
    std::vector<std::string> examples;
};

struct CommandTable {
    std::string version;
    std::string meaning;
    std::vector<OptionRow> options;  ///< options that need no command
    std::vector<CommandRow> commands;
};

CommandTable command_table();

}  // namespace lancer::cli
