// make_pages DIR: writes manual pages, shell completions and editor files below DIR, one folder per
// program that reads them. SOURCE_DATE_EPOCH, if set, gives the date of the pages, so that builds
// are reproducible.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "cli/command_table.h"
#include "cli/pages/completions.h"
#include "cli/pages/editors.h"
#include "cli/pages/man_page.h"
#include "model/io/file.h"

namespace {

using namespace lancer;

std::string date() {
    std::time_t seconds = std::time(nullptr);
    if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
        char* end = nullptr;
        seconds = std::strtoll(epoch, &end, 10);
        if (end == epoch || *end != '\0')
            throw std::runtime_error("SOURCE_DATE_EPOCH is not a number of seconds");
    }
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(seconds));
}

void write(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    io::write_file(path.string(), text);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) throw std::runtime_error("usage: make_pages DIR");
    const std::filesystem::path folder = argv[1];
    const cli::CommandTable table = cli::command_table();
    const std::string today = date();
    write(folder / "man/lancer.1", program_page(table, today));
    for (const cli::CommandRow& command : table.commands)
        write(folder / ("man/lancer-" + command.name + ".1"), command_page(table, command, today));
    write(folder / "bash/lancer", bash_completion(table));
    write(folder / "zsh/_lancer", zsh_completion(table));
    write(folder / "fish/lancer.fish", fish_completion(table));
    const cli::LanguageWords words = cli::language_words();
    write(folder / "vim/syntax/lancer.vim", vim_syntax(words));
    write(folder / "vim/ftdetect/lancer.vim", cli::vim_detection());
    write(folder / "vim/ftplugin/lancer.vim", cli::vim_settings());
    write(folder / "vscode/package.json", cli::vscode_package(table.version));
    write(folder / "vscode/language-configuration.json", cli::vscode_language());
    write(folder / "vscode/syntaxes/lancer.tmLanguage.json", textmate_grammar(words));
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "make_pages: {}\n", error.what());
    return 1;
}
