#include "cli/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "model/utf8.h"

namespace lancer::cli {
namespace {

constexpr std::string_view bold = "\033[1m";
constexpr std::string_view green = "\033[1;32m";
constexpr std::string_view plain = "\033[0m";

bool variable_is_set(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
}

void put(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
}

/// Colours `place: error: message`; leaves any other line as it is.
std::string color_heading(std::string_view line) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kinds{{
        {": error: ", "\033[1;31m"},
        {": warning: ", "\033[1;35m"},
        {": note: ", "\033[1;36m"},
    }};
    for (const auto& [kind, color] : kinds) {
        const std::size_t at = line.find(kind);
        if (at == std::string_view::npos) continue;
        const std::string_view word = kind.substr(2, kind.size() - 3);
        return fmt::format("{}{}:{} {}{}{} {}", bold, line.substr(0, at), plain, color, word, plain,
                           line.substr(at + kind.size()));
    }
    return std::string(line);
}

}  // namespace

Terminal::Terminal()
    : interactive_(isatty(STDERR_FILENO) == 1),
      colors_(interactive_ && !variable_is_set("NO_COLOR")) {
    const char* type = std::getenv("TERM");
    if (type != nullptr && std::string_view(type) == "dumb") interactive_ = colors_ = false;
}

int Terminal::columns() const {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    return 80;
}

std::size_t Terminal::show(std::vector<Diagnostic> found, const SourceMap& sources) const {
    std::stable_sort(found.begin(), found.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.where.file, a.where.offset) < std::tie(b.where.file, b.where.offset);
    });
    std::size_t errors = 0;
    std::size_t warnings = 0;
    for (const Diagnostic& diagnostic : found) {
        const std::string text = format(diagnostic, sources);
        put(colors_ ? with_colors(text) : text);
        errors += diagnostic.severity == Severity::error ? 1 : 0;
        warnings += diagnostic.severity == Severity::warning ? 1 : 0;
    }
    if (errors + warnings > 1) {
        const auto count = [](std::size_t n, const char* what) {
            return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
        };
        line(warnings == 0 ? count(errors, "error")
             : errors == 0 ? count(warnings, "warning")
                           : count(errors, "error") + ", " + count(warnings, "warning"));
    }
    return errors;
}

void Terminal::error(const std::string& message) const {
    // The output of another program stands in indented lines of its own.
    constexpr std::string_view indented_line = "\n    ";
    std::string text = "lancer: error: ";
    std::string_view rest = message;
    for (std::size_t end = 0; (end = rest.find(indented_line)) != std::string_view::npos;) {
        text += printable(rest.substr(0, end)) + std::string(indented_line);
        rest.remove_prefix(end + indented_line.size());
    }
    text += printable(rest) + "\n";
    put(colors_ ? with_colors(text) : text);
}

void Terminal::line(std::string_view text) const {
    put(fmt::format("{}\n", text));
}

void Terminal::lines(const std::vector<std::string>& texts) const {
    std::string all;
    for (const std::string& text : texts) {
        all += text;
        all += '\n';
        if (all.size() > 65536) {
            put(all);
            all.clear();
        }
    }
    if (!all.empty()) put(all);
}

std::string with_colors(std::string_view diagnostic) {
    std::string out;
    while (!diagnostic.empty()) {
        const std::size_t end = std::min(diagnostic.find('\n'), diagnostic.size());
        const std::string_view line = diagnostic.substr(0, end);
        diagnostic.remove_prefix(std::min(end + 1, diagnostic.size()));
        const std::size_t first = line.find_first_not_of(" \t");
        const bool is_caret = first != std::string_view::npos && line[first] == '^' &&
                              line.find_first_not_of('~', first + 1) == std::string_view::npos;
        if (!line.starts_with("    ")) {
            out += color_heading(line);
        } else if (is_caret) {
            out += fmt::format("{}{}{}{}", line.substr(0, first), green, line.substr(first), plain);
        } else {
            out += line;
        }
        out += '\n';
    }
    return out;
}

}  // namespace lancer::cli
