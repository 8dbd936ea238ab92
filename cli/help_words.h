// The text that is common to help and manual pages of all commands.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lancer::cli {

struct HelpWord {
    std::string_view word;
    std::string_view meaning;
};

std::span<const HelpWord> exit_code_words();
std::span<const HelpWord> environment_words();

/// The text at the end of `lancer --help`.
std::string general_help();

}  // namespace lancer::cli
