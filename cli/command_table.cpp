#include "cli/command_table.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include "cli/command_line.h"

namespace lancer::cli {
namespace {

/// The words of `draft|normal|fine`. Words in capitals are placeholders for other values.
std::vector<std::string> words_in(const std::string& value) {
    std::vector<std::string> words;
    if (value.find('|') == std::string::npos) return words;
    std::istringstream in(value);
    for (std::string word; std::getline(in, word, '|');)
        if (!word.empty() && !std::isupper(static_cast<unsigned char>(word[0])))
            words.push_back(word);
    return words;
}

ValueKind kind_of(std::string_view value) {
    if (value.find('|') != std::string_view::npos) return ValueKind::words;
    if (value == "DIR") return ValueKind::folder;
    if (value == "SCENE") return ValueKind::scene;
    for (const std::string_view file : {"FILE", "OUT", "PICTURE", "PARTS", "A", "B"})
        if (value == file) return ValueKind::file;
    // `OUT.pov`: a placeholder with the ending that the file name must have.
    return value.find('.') != std::string_view::npos && value.find("..") == std::string_view::npos
               ? ValueKind::file
               : ValueKind::free;
}

OptionRow row_of(const CLI::Option& option) {
    OptionRow row;
    for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
    if (option.get_items_expected_max() > 0) {
        row.value = option.get_type_name();
        row.kind = kind_of(row.value);
        row.words = words_in(row.value);
    }
    row.meaning = option.get_description();
    row.group = option.get_group();
    row.is_required = option.get_required();
    row.may_repeat = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
    return row;
}

std::vector<OptionRow> options_of(const CLI::App& app) {
    std::vector<OptionRow> rows;
    for (const std::string& group : app.get_groups())
        for (const CLI::Option* option : app.get_options())
            if (option->nonpositional() && option->get_group() == group)
                rows.push_back(row_of(*option));
    return rows;
}

std::vector<std::string> examples_in(const std::string& footer) {
    std::vector<std::string> examples;
    std::istringstream in(footer);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("  ")) examples.push_back(line.substr(2));
    return examples;
}

}  // namespace

CommandTable command_table() {
    CLI::App app;
    Action action;
    set_up_command_line(app, action);
    CommandTable table{LANCER_VERSION, app.get_description(), options_of(app), {}};
    for (const CLI::App* command : app.get_subcommands({})) {
        CommandRow row{command->get_name(),
                       command->get_description(),
                       {},
                       options_of(*command),
                       examples_in(command->get_footer())};
        for (const CLI::Option* option : command->get_options()) {
            if (!option->get_positional()) continue;
            const std::string name = option->get_name(true);
            row.arguments.push_back(
                {name, kind_of(name), option->get_description(),
                 option->get_expected_max() >= CLI::detail::expected_max_vector_size});
        }
        table.commands.push_back(std::move(row));
    }
    return table;
}

}  // namespace lancer::cli
