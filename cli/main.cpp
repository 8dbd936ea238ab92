// The command line: its first word is a command, the rest belongs to that command.
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "cli/command_line.h"
#include "cli/guarded.h"
#include "cli/interrupt.h"
#include "cli/session.h"
#include "model/io/picture_messages.h"
#include "model/io/picture_process.h"
#include "model/io/picture_server.h"
#include "parser/suggest.h"

namespace lancer::cli {
namespace {

/// Reports a first word that is not a command.
void refuse_unknown_command(const CLI::App& app, int argc, char** argv) {
    const std::string word = argc > 1 ? argv[1] : "";
    if (word.starts_with("-")) return;
    std::string names;
    for (const CLI::App* command : app.get_subcommands({})) {
        if (command->get_name() == word) return;
        names += (names.empty() ? "" : ", ") + command->get_name();
    }
    throw UsageError(
        (word.empty() ? "a command is missing" : "there is no command '" + word + "'") +
        ": expected one of " + names);
}

/// A hint for an option's name from other renderers; empty when there is none.
std::string habit_hint(const CLI::App& command, std::string word) {
    struct Habit {
        const char* word;
        const char* option;
        const char* hint;
    };
    static constexpr Habit habits[] = {
        {"--width", "--size", "use --size 640x480 for the size of a picture"},
        {"--height", "--size", "use --size 640x480 for the size of a picture"},
        {"--resolution", "--size", "use --size 640x480 for the size of a picture"},
        {"--res", "--size", "use --size 640x480 for the size of a picture"},
        {"--spp", "--samples", "use --samples 3 for 3 x 3 rays per pixel"},
        {"--antialias", "--samples", "use --samples 3 for 3 x 3 rays per pixel"},
        {"--aa", "--samples", "use --samples 3 for 3 x 3 rays per pixel"},
        {"--draft", "--preview", "use --preview for a quick look"},
    };
    word = word.substr(0, word.find('='));
    for (const Habit& habit : habits) {
        if (word == habit.word && command.get_option_no_throw(habit.option) != nullptr)
            return habit.hint;
    }
    return {};
}

/// A message about the first argument that the command does not take.
std::string unexpected_argument(const CLI::App& app, const std::string& otherwise) {
    for (const CLI::App* command : app.get_subcommands()) {
        const std::vector<std::string> rest = command->remaining();
        if (rest.empty()) continue;
        // The word after an unknown option may be that option's value.
        const auto option = std::ranges::find_if(
            rest, [](const std::string& argument) { return argument.starts_with("-"); });
        if (option == rest.end()) return "unexpected argument '" + rest.front() + "'";
        const std::string& word = *option;
        const std::string start =
            "'" + command->get_name() + "' has no option '" + word.substr(0, word.find('=')) + "'";
        if (const std::string hint = habit_hint(*command, word); !hint.empty())
            return start + ": " + hint;
        Suggestion suggestion(word);
        for (const CLI::Option* known : command->get_options())
            for (const std::string& name : known->get_lnames()) suggestion.consider("--" + name);
        return start + (suggestion.empty() ? "" : ": " + suggestion.hint());
    }
    return otherwise;
}

ExitCode parse_and_run(int argc, char** argv, Session& session) {
    CLI::App app;
    Action action;
    set_up_command_line(app, action);
    refuse_unknown_command(app, argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        std::ostringstream text;
        app.exit(help, text, text);  // the requested help or version
        session.output.put(text.str());
        return ExitCode::done;
    } catch (const CLI::ExtrasError& error) {
        throw UsageError(unexpected_argument(app, error.what()));
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    return action(session);
}

}  // namespace
}  // namespace lancer::cli

// If memory runs out while an error is being reported, ending the process is the best that is left.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    using namespace lancer;
    using namespace lancer::cli;
    // The program starts itself with this word to work on pictures; the word is not for users.
    const bool asked_to_serve = argc == 2 && std::string_view(argv[1]) == io::picture_server_word;
    if (asked_to_serve && io::serve_pictures(STDIN_FILENO)) std::_Exit(0);
    open_missing_streams();
    io::set_picture_program("/proc/self/exe");
    end_on_interrupt();
    keep_on_broken_output();
    Session session;
    return static_cast<int>(guarded(session, [&] { return parse_and_run(argc, argv, session); }));
}
