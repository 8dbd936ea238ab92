#include <fmt/format.h>

#include "cli/pages/completions.h"

namespace lancer::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
    return fmt::format("{}", fmt::join(words, between));
}

/// The completion for a value of this kind; empty when there is none.
std::string offer(ValueKind kind, const std::vector<std::string>& words) {
    switch (kind) {
        case ValueKind::words:
            return fmt::format("words='{}'", joined(words, " "));
        case ValueKind::file:
            return "files=any";
        case ValueKind::scene:
            return "files=scenes";
        case ValueKind::folder:
            return "files=folders";
        case ValueKind::free:
            break;
    }
    return {};
}

std::string names_of(const std::vector<OptionRow>& options) {
    std::string names;
    for (const OptionRow& option : options)
        for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
    return names;
}

std::string command_case(const CommandRow& command) {
    std::string text = fmt::format("        {})\n            case $previous in\n", command.name);
    std::vector<std::string> unknown;
    for (const OptionRow& option : command.options) {
        if (option.value.empty()) continue;
        const std::string what = offer(option.kind, option.words);
        if (what.empty()) {
            unknown.insert(unknown.end(), option.names.begin(), option.names.end());
        } else {
            text += fmt::format("                {}) {} ;;\n", joined(option.names, " | "), what);
        }
    }
    if (!unknown.empty())
        text += fmt::format("                {}) return ;;\n", joined(unknown, " | "));
    const std::string argument =
        command.arguments.empty() ? "" : offer(command.arguments.front().kind, {});
    text +=
        fmt::format("                *) options='{}' {} ;;\n", names_of(command.options), argument);
    return text + "            esac\n            ;;\n";
}

}  // namespace

std::string bash_completion(const CommandTable& table) {
    std::vector<std::string> commands;
    for (const CommandRow& command : table.commands) commands.push_back(command.name);
    std::string text = R"(# shellcheck shell=bash
# What bash completes after `lancer`; made from the program's own tables of options.
_lancer() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
    # Bash takes --quality=fine for three words.
    if [ "$current" = = ]; then
        current=
    elif [ "$previous" = = ] && [ "$COMP_CWORD" -ge 3 ]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    local command=${COMP_WORDS[1]} options='' words='' files=''
    [ "$COMP_CWORD" -gt 1 ] || command=
    case $command in
)";
    text += fmt::format("        '') options='{}' words='{}' ;;\n", names_of(table.options),
                        joined(commands, " "));
    for (const CommandRow& command : table.commands) text += command_case(command);
    return text + R"(    esac
    COMPREPLY=()
    if [[ $current == -* && -n $options ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
        return
    fi
    case $files in
        '') mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current") ;;
        any) mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
        scenes) mapfile -t COMPREPLY < <(compgen -f -X '!*.lancer' -- "$current"; compgen -d -- "$current") ;;
        folders) mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
    esac
    [ -z "$files" ] || compopt -o filenames 2> /dev/null
}
complete -F _lancer lancer
)";
}

}  // namespace lancer::cli
