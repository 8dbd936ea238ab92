// Files by which editors colour scenes; made from the tables of the language.
#pragma once

#include <string>

#include "cli/pages/language_words.h"

namespace lancer::cli {

/// Vim: syntax/lancer.vim.
std::string vim_syntax(const LanguageWords& words);
/// Vim: ftdetect/lancer.vim, which knows scenes by their names.
std::string vim_detection();
/// Vim: ftplugin/lancer.vim: comments, and `:make`, which checks the scene and goes to its
/// mistakes.
std::string vim_settings();

/// VS Code: package.json of an extension in a folder of its own.
std::string vscode_package(const std::string& version);
/// Its language-configuration.json: comments and brackets.
std::string vscode_language();
/// Its syntaxes/lancer.tmLanguage.json, which other editors read, too (TextMate, Sublime Text,
/// Kate).
std::string textmate_grammar(const LanguageWords& words);

}  // namespace lancer::cli
