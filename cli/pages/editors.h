// Syntax files for editors, made from the tables of the language.
#pragma once

#include <string>

#include "cli/pages/language_words.h"

namespace lancer::cli {

/// Vim: syntax/lancer.vim.
std::string vim_syntax(const LanguageWords& words);
/// Vim: ftdetect/lancer.vim, which recognizes scenes by their file names.
std::string vim_detection();
/// Vim: ftplugin/lancer.vim with comments and `:make`, which checks the scene and jumps to its
/// errors.
std::string vim_settings();

/// VS Code: package.json of an extension in a folder of its own.
std::string vscode_package(const std::string& version);
/// Its language-configuration.json: comments and brackets.
std::string vscode_language();
/// Its syntaxes/lancer.tmLanguage.json, which other editors can read, too (TextMate, Sublime Text,
/// Kate).
std::string textmate_grammar(const LanguageWords& words);

}  // namespace lancer::cli
