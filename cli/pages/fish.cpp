#include <fmt/format.h>

#include "cli/pages/completions.h"

namespace lancer::cli {
namespace {

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\\' || c == '\'') result += '\\';
        result += c;
    }
    return result + "'";
}

/// The words of `complete` for a value of this kind.
std::string value_words(ValueKind kind, const std::vector<std::string>& words) {
    switch (kind) {
        case ValueKind::words:
            return fmt::format(" -x -a '{}'", fmt::join(words, " "));
        case ValueKind::file:
            return " -r -F";
        case ValueKind::scene:
            return " -x -a '(__fish_complete_suffix .lancer)'";
        case ValueKind::folder:
            return " -x -a '(__fish_complete_directories)'";
        case ValueKind::free:
            break;
    }
    return " -x";
}

std::string option_line(const std::string& condition, const OptionRow& option) {
    std::string text = fmt::format("complete -c lancer -n {}", quoted(condition));
    for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (!option.value.empty()) text += value_words(option.kind, option.words);
    return text + " -d " + quoted(option.meaning) + "\n";
}

}  // namespace

std::string fish_completion(const CommandTable& table) {
    const std::string before_command = "__fish_use_subcommand";
    std::string text =
        "# What fish completes after `lancer`; made from the program's own tables of options.\n"
        "complete -c lancer -f\n";
    for (const OptionRow& option : table.options) text += option_line(before_command, option);
    for (const CommandRow& command : table.commands) {
        text += fmt::format("complete -c lancer -n {} -a {} -d {}\n", before_command, command.name,
                            quoted(command.meaning));
    }
    for (const CommandRow& command : table.commands) {
        const std::string after = "__fish_seen_subcommand_from " + command.name;
        for (const OptionRow& option : command.options) text += option_line(after, option);
        if (command.arguments.empty()) continue;
        const ValueKind kind = command.arguments.front().kind;
        if (kind == ValueKind::file)
            text += fmt::format("complete -c lancer -n {} -F\n", quoted(after));
        if (kind == ValueKind::scene)
            text += fmt::format("complete -c lancer -n {} -a '(__fish_complete_suffix .lancer)'\n",
                                quoted(after));
    }
    return text;
}

}  // namespace lancer::cli
