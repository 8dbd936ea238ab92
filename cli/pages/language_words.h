// The words of the language, by how an editor shows them.
#pragma once

#include <set>
#include <string>

namespace lancer::cli {

/// Each word is in exactly one set.
struct LanguageWords {
    std::set<std::string> statements;  ///< `let`, `for`, …
    std::set<std::string> blocks;      ///< `sphere`, …
    std::set<std::string> properties;  ///< `radius`, …
    std::set<std::string> values;      ///< `checker`, …: what a property may be
    std::set<std::string> functions;   ///< `sin`, …
    std::set<std::string> constants;   ///< `pi`, …
};

LanguageWords language_words();

}  // namespace lancer::cli
