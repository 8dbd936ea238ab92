#include <fmt/format.h>

#include "cli/pages/completions.h"

namespace lancer::cli {
namespace {

/// Text for use inside '…' of a script, with a backslash before each character of `special`.
std::string quoted(const std::string& text, std::string_view special) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
            continue;
        }
        if (c == '\\' || special.find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

std::string action(ValueKind kind, const std::vector<std::string>& words) {
    switch (kind) {
        case ValueKind::words:
            return fmt::format("({})", fmt::join(words, " "));
        case ValueKind::file:
            return "_files";
        case ValueKind::scene:
            return "_files -g \"*.lancer\"";
        case ValueKind::folder:
            return "_files -/";
        case ValueKind::free:
            break;
    }
    return " ";
}

/// One argument of _arguments: `'(-o --output)'{-o+,--output=}'[meaning]:OUT:_files'`.
std::string specification(const OptionRow& option) {
    const bool takes = !option.value.empty();
    std::vector<std::string> forms;
    for (const std::string& name : option.names)
        forms.push_back(name + (!takes ? "" : name.starts_with("--") ? "=" : "+"));
    std::string text;
    if (option.may_repeat) {
        text = "'*'";
    } else if (forms.size() > 1) {
        text = fmt::format("'({})'", fmt::join(option.names, " "));
    }
    text += forms.size() > 1 ? fmt::format("{{{}}}", fmt::join(forms, ",")) : forms.front();
    text += fmt::format("'[{}]", quoted(option.meaning, "[]:"));
    if (takes)
        text += fmt::format(":{}:{}", quoted(option.value, ":"), action(option.kind, option.words));
    return text + "'";
}

std::string command_case(const CommandRow& command) {
    std::string text =
        fmt::format("                {})\n                    _arguments -S", command.name);
    const std::string next = " \\\n                        ";
    for (const OptionRow& option : command.options) text += next + specification(option);
    int number = 1;
    for (const ArgumentRow& argument : command.arguments) {
        const std::string place = argument.may_repeat ? "*" : std::to_string(number++);
        text += next + fmt::format("'{}:{}:{}'", place, argument.name, action(argument.kind, {}));
    }
    return text + "\n                    ;;\n";
}

}  // namespace

std::string zsh_completion(const CommandTable& table) {
    std::string text = R"(#compdef lancer
# What zsh completes after `lancer`; made from the program's own tables of options.
_lancer() {
    local curcontext="$curcontext" state state_descr line
    typeset -A opt_args
    _arguments -C)";
    for (const OptionRow& option : table.options) text += " \\\n        " + specification(option);
    text += R"( \
        '1: :->command' \
        '*:: :->rest'
    case $state in
        command)
            local -a commands
            commands=(
)";
    for (const CommandRow& command : table.commands)
        text += fmt::format("                '{}:{}'\n", command.name, quoted(command.meaning, ""));
    text += R"(            )
            _describe -t commands command commands
            ;;
        rest)
            case $line[1] in
)";
    for (const CommandRow& command : table.commands) text += command_case(command);
    return text + R"(            esac
            ;;
    esac
}
_lancer "$@"
)";
}

}  // namespace lancer::cli
