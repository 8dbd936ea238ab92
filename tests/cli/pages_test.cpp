// Manual pages and completions say all that the program's help says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "cli/command_table.h"
#include "cli/pages/completions.h"
#include "cli/pages/editors.h"
#include "cli/pages/man_page.h"
#include "cli/pages/roff.h"
#include "parser/field.h"
#include "parser/functions.h"
#include "parser/scan.h"
#include "tests/cli/run_lancer.h"

namespace lancer::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;

std::set<std::string> options_in(const std::string& text) {
    static const std::regex option("--?[A-Za-z][a-z-]*");
    std::set<std::string> found;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), option);
         match != std::sregex_iterator(); ++match)
        found.insert(match->str());
    return found;
}

std::set<std::string> names_of(const std::vector<OptionRow>& options) {
    std::set<std::string> names;
    for (const OptionRow& option : options) names.insert(option.names.begin(), option.names.end());
    return names;
}

const OptionRow& option_called(const std::string& command, const std::string& name) {
    static const CommandTable table = command_table();
    for (const CommandRow& row : table.commands)
        if (row.name == command)
            for (const OptionRow& option : row.options)
                for (const std::string& known : option.names)
                    if (known == name) return option;
    throw std::runtime_error(command + " has no " + name);
}

/// The lines that begin with an option, as in `  -o,--output OUT   Picture`.
std::set<std::string> options_of_help(const std::string& help) {
    std::set<std::string> names;
    std::istringstream in(help);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("  -")) names.merge(options_in(line.substr(0, line.find(' ', 2))));
    return names;
}

TEST(Pages, AreMadeOfTheOptionsThatHelpShows) {
    const Workplace place;
    const CommandTable table = command_table();
    EXPECT_EQ(options_of_help(place.run({"--help"}).out), names_of(table.options));
    EXPECT_GE(table.commands.size(), 11u);
    for (const CommandRow& command : table.commands) {
        const std::string help = place.run({command.name, "--help"}).out;
        EXPECT_EQ(options_of_help(help), names_of(command.options)) << command.name;
        for (const ArgumentRow& argument : command.arguments)
            EXPECT_THAT(help, HasSubstr(argument.name)) << command.name;
    }
}

TEST(Pages, OfTheManualNameEveryCommandAndOption) {
    const CommandTable table = command_table();
    const std::string program = program_page(table, "2026-01-01");
    for (const CommandRow& command : table.commands) {
        EXPECT_THAT(program, HasSubstr(".BR lancer\\-" + command.name + " (1)"));
        const std::string page = command_page(table, command, "2026-01-01");
        EXPECT_THAT(page, HasSubstr("\"Lancer " + table.version + "\""));
        for (const OptionRow& option : command.options) {
            for (const std::string& name : option.names)
                EXPECT_THAT(page, HasSubstr("\\fB" + roff(name) + "\\fR")) << command.name;
            EXPECT_THAT(page, HasSubstr(roff(option.meaning))) << command.name;
        }
        EXPECT_FALSE(command.examples.empty()) << command.name;
    }
}

TEST(Pages, ThatShellsReadNameEveryCommandAndOption) {
    const CommandTable table = command_table();
    const std::string bash = bash_completion(table);
    const std::string zsh = zsh_completion(table);
    const std::string fish = fish_completion(table);
    for (const CommandRow& command : table.commands) {
        const std::string own_part = bash.substr(bash.find("        " + command.name + ")\n"));
        const std::set<std::string> offered = options_in(own_part.substr(0, own_part.find("esac")));
        EXPECT_THAT(offered, IsSupersetOf(names_of(command.options))) << command.name;
        EXPECT_THAT(zsh, HasSubstr("'" + command.name + ":"));
        EXPECT_THAT(fish, HasSubstr("-a " + command.name + " -d"));
        for (const OptionRow& option : command.options)
            for (const std::string& name : option.names) {
                EXPECT_THAT(zsh, HasSubstr(name));
                EXPECT_THAT(fish, HasSubstr((name.starts_with("--") ? "-l " + name.substr(2)
                                                                    : "-s " + name.substr(1))));
            }
    }
}

TEST(Pages, KnowWhatAValueMayBe) {
    EXPECT_THAT(option_called("render", "--quality").words,
                ElementsAre("draft", "normal", "fine", "exact"));
    EXPECT_THAT(option_called("render", "--bits").words, ElementsAre("8", "16"));
    EXPECT_THAT(option_called("validate", "--encoding").words,
                ElementsAre("auto", "linear", "srgb"));
    EXPECT_EQ(option_called("render", "-o").kind, ValueKind::file);
    EXPECT_EQ(option_called("export", "-o").kind, ValueKind::file);
    EXPECT_EQ(option_called("validate", "--report").kind, ValueKind::folder);
    EXPECT_EQ(option_called("render", "--frames").kind, ValueKind::free);
    EXPECT_EQ(option_called("render", "--aov").value, "");
    EXPECT_TRUE(option_called("export", "-o").is_required);
    EXPECT_TRUE(option_called("render", "-D").may_repeat);
    EXPECT_FALSE(option_called("render", "--size").may_repeat);
}

TEST(Pages, EscapeWhatRoffWouldTakeForACommand) {
    EXPECT_EQ(roff("--size"), "\\-\\-size");
    EXPECT_EQ(roff(".png is `first`"), "\\&.png is \\fBfirst\\fR");
    EXPECT_EQ(roff("2^10 \\ ~ it's"), "2\\(ha10 \\e \\(ti it\\(aqs");
}

TEST(Editors, ColourEveryWordOfTheLanguage) {
    const LanguageWords words = language_words();
    for (const std::string& word : words.statements) EXPECT_TRUE(scan::is_reserved(word)) << word;
    const std::string vim = vim_syntax(words);
    const std::string grammar = textmate_grammar(words);
    std::size_t count = 0;
    const auto expect_word = [&](std::string_view word) {
        if (word.empty()) return;
        const std::regex whole("[^a-z0-9_]" + std::string(word) + "[^a-z0-9_]", std::regex::icase);
        EXPECT_TRUE(std::regex_search(vim, whole)) << word;
        EXPECT_TRUE(std::regex_search(grammar, whole)) << word;
        ++count;
    };
    for (const BlockInfo& block : all_blocks()) {
        expect_word(block.keyword);
        expect_word(block.kind);
        for (const auto& fields : {block.own, block.shared})
            for (const Field& field : fields) {
                expect_word(field.name);
                for (const std::string_view word : field.words) expect_word(word);
            }
    }
    for (const Function& function : all_functions()) expect_word(function.name);
    for (const Constant& constant : all_constants()) expect_word(constant.name);
    EXPECT_GT(count, 200u);
}

TEST(Editors, GetJsonThatNamesItsFiles) {
    const auto package = nlohmann::json::parse(vscode_package("1.2.3"));
    EXPECT_EQ(package["version"], "1.2.3");
    EXPECT_EQ(package["contributes"]["grammars"][0]["path"], "./syntaxes/lancer.tmLanguage.json");
    const auto grammar = nlohmann::json::parse(textmate_grammar(language_words()));
    EXPECT_EQ(grammar["scopeName"], package["contributes"]["grammars"][0]["scopeName"]);
    EXPECT_EQ(nlohmann::json::parse(vscode_language())["comments"]["lineComment"], "//");
    for (const auto& rule : grammar["patterns"])
        EXPECT_TRUE(rule.contains("match") || rule.contains("begin")) << rule;
}

}  // namespace
}  // namespace lancer::cli
