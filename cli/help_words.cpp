#include "cli/help_words.h"

#include <fmt/format.h>

#include <array>

namespace lancer::cli {

std::span<const HelpWord> exit_code_words() {
    static constexpr std::array words{
        HelpWord{"0", "done"},
        HelpWord{"1", "pictures differ, an error is not reached, or a check failed"},
        HelpWord{"2", "wrong use of the command line"},
        HelpWord{"3", "the scene has errors, or names a file that cannot be read"},
        HelpWord{"4",
                 "a file cannot be read or written, POV-Ray is missing or failed, or the system "
                 "has no memory or thread left"},
        HelpWord{"70", "a bug in Lancer: please report it"},
        HelpWord{"75", "trying again may help: parts are missing, or a network failed"},
        HelpWord{"130", "interrupted (143: terminated)"},
    };
    return words;
}

std::span<const HelpWord> environment_words() {
    static constexpr std::array words{
        HelpWord{"LANCER_POVRAY",
                 "the POV-Ray program to run; by default the first povray in PATH"},
        HelpWord{"LANCER_CACHE",
                 "the folder that keeps POV-Ray's pictures and truths; by default lancer in "
                 "XDG_CACHE_HOME, or ~/.cache/lancer"},
        HelpWord{"NO_COLOR", "if it is set and not empty, messages have no colours"},
        HelpWord{"TMPDIR", "the folder in which POV-Ray works; by default /tmp"},
    };
    return words;
}

std::string general_help() {
    std::string text = "Exit codes:";
    for (const auto& [word, meaning] : exit_code_words())
        text += fmt::format("\n  {:<4}{}", word, meaning);
    text += "\n\nEnvironment:";
    for (const auto& [word, meaning] : environment_words())
        text += fmt::format("\n  {:<15}{}", word, meaning);
    return text + "\n\n`lancer COMMAND --help` shows the options of a command.";
}

}  // namespace lancer::cli
