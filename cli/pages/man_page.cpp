#include "cli/pages/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <span>

#include "cli/help_words.h"
#include "cli/pages/roff.h"

namespace lancer::cli {
namespace {

std::string heading(const CommandTable& table, const std::string& name, const std::string& date) {
    std::string capitals = name;
    std::ranges::transform(capitals, capitals.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return fmt::format(
        ".\\\" Made from the program's own tables of options.\n"
        ".TH {} 1 {} \"Lancer {}\" \"Lancer Manual\"\n"
        ".\\\" No hyphenation, and a ragged right margin: names of options stay whole.\n"
        ".nh\n.ad l\n",
        roff(capitals), date, table.version);
}

/// The text after `lancer-render \-`, as whatis(1) lists it: one line that begins with a small
/// letter.
std::string name_section(const std::string& name, std::string meaning) {
    if (!meaning.empty())
        meaning[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(meaning[0])));
    return fmt::format(".SH NAME\n{} \\- {}\n", roff(name), roff(meaning));
}

std::string option_entry(const OptionRow& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
    if (!option.value.empty()) {
        // Words to choose from are typed literally, so they are bold.
        const char font = option.kind == ValueKind::words ? 'B' : 'I';
        names += fmt::format(" \\f{}{}\\fR", font, roff(option.value));
    }
    return fmt::format(".TP\n{}\n{}.{}\n", names, roff(option.meaning),
                       option.is_required ? " Required." : "");
}

std::string options_section(const std::vector<OptionRow>& options) {
    std::string text = ".SH OPTIONS\n";
    std::string group = "Options";
    for (const OptionRow& option : options) {
        if (option.group != group) text += fmt::format(".SS {}\n", roff(option.group));
        group = option.group;
        text += option_entry(option);
    }
    return text;
}

std::string words_section(const std::string& title, std::span<const HelpWord> words) {
    std::string text = fmt::format(".SH {}\n", title);
    for (const auto& [word, meaning] : words)
        text += fmt::format(".TP\n.B {}\n{}.\n", roff(word), roff(meaning));
    return text;
}

std::string examples_section(const std::vector<std::string>& examples) {
    if (examples.empty()) return {};
    std::string text = ".SH EXAMPLES\n.nf\n";
    for (const std::string& example : examples) text += roff(example) + "\n";
    return text + ".fi\n";
}

std::string see_also(const std::vector<std::string>& pages) {
    std::string text = ".SH SEE ALSO\n";
    for (const std::string& page : pages) text += fmt::format(".BR {} (1),\n", roff(page));
    return text +
           "and the documentation in\n.IR share/doc/lancer/docs ,\nof which\n.I command\\-line.md\n"
           "says more of each option and\n.I language.md\nwhat a scene may hold.\n";
}

}  // namespace

std::string program_page(const CommandTable& table, const std::string& date) {
    std::string text = heading(table, "lancer", date);
    text += name_section("lancer", "a small scene language and the ray tracer that renders it");
    text +=
        ".SH SYNOPSIS\n.B lancer\n.I command\n.RI [ arguments ]\n.RI [ options ]\n"
        ".SH DESCRIPTION\n"
        "Lancer reads a scene, a text, and renders it to a picture. It judges its pictures "
        "against\n"
        "POV\\-Ray's, and tells why they differ where they do.\n"
        "A scene named\n.B \\-\nis read from standard input.\n"
        "No file that a command reads is written over, and no file is left half written.\n"
        ".SH COMMANDS\n";
    std::vector<std::string> pages;
    for (const CommandRow& command : table.commands) {
        text += fmt::format(".TP\n.BR lancer\\-{} (1)\n{}.\n", roff(command.name),
                            roff(command.meaning));
        pages.push_back("lancer-" + command.name);
    }
    text += options_section(table.options);
    text += words_section("EXIT STATUS", exit_code_words());
    text += words_section("ENVIRONMENT", environment_words());
    text += examples_section({"lancer render scene.lancer", "lancer validate scene.lancer"});
    pages.push_back("povray");
    return text + see_also(pages);
}

std::string command_page(const CommandTable& table, const CommandRow& command,
                         const std::string& date) {
    const std::string name = "lancer-" + command.name;
    std::string text = heading(table, name, date);
    text += name_section(name, command.meaning);
    text += fmt::format(".SH SYNOPSIS\n.B lancer {}\n", roff(command.name));
    for (const ArgumentRow& argument : command.arguments)
        text += argument.may_repeat ? fmt::format(".IR {} ...\n", roff(argument.name))
                                    : fmt::format(".I {}\n", roff(argument.name));
    for (const OptionRow& option : command.options)
        if (option.is_required)
            text += fmt::format(".B {}\n.I {}\n", roff(option.names.front()), roff(option.value));
    text += ".RI [ options ]\n.SH DESCRIPTION\n" + roff(command.meaning) + ".\n";
    for (const ArgumentRow& argument : command.arguments)
        text += fmt::format(".TP\n.I {}\n{}.\n", roff(argument.name), roff(argument.meaning));
    text += options_section(command.options);
    text += ".SH EXIT STATUS\n0: done; others are listed in\n.BR lancer (1).\n";
    text += examples_section(command.examples);
    return text + see_also({"lancer"});
}

}  // namespace lancer::cli
