#include "model/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/utf8.h"

namespace lancer {
namespace {

constexpr std::size_t widest_quote = 100;

bool is_continuation_byte(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// The quoted line and the caret line below it.
std::string quote(const SourceSpan& where, const SourceMap& sources) {
    std::string_view line = sources.line_text(where);
    std::size_t caret = std::min<std::size_t>(sources.locate(where).column - 1, line.size());
    std::string_view before_cut;
    std::string_view after_cut;
    if (line.size() > widest_quote) {
        std::size_t from = caret > widest_quote / 2 ? caret - widest_quote / 2 : 0;
        from = std::min(from, line.size() - widest_quote);
        std::size_t to = from + widest_quote;
        // Never cut within a UTF-8 character.
        while (from > 0 && is_continuation_byte(line[from])) --from;
        while (to < line.size() && is_continuation_byte(line[to])) ++to;
        if (from > 0) before_cut = "...";
        if (to < line.size()) after_cut = "...";
        line = line.substr(from, to - from);
        caret -= from;
    }
    std::string under(before_cut.size(), ' ');
    for (const char c : line.substr(0, caret)) {
        if (!is_continuation_byte(c)) under += c == '\t' ? '\t' : ' ';
    }
    under += '^';
    const std::string_view marked = line.substr(caret, std::max<std::size_t>(where.length, 1));
    bool first = true;
    for (const char c : marked) {
        if (!first && !is_continuation_byte(c)) under += '~';
        first = false;
    }
    std::string shown(line);
    for (char& c : shown) {
        const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\t';
        if (control || c == 0x7F) c = '?';  // no escape sequence may reach the terminal
    }
    for (std::size_t bad = 0; (bad = find_invalid_utf8(shown, bad)) != std::string::npos;)
        shown[bad] = '?';
    return fmt::format("    {}{}{}\n    {}\n", before_cut, shown, after_cut, under);
}

void append(std::string& out, const Diagnostic& d, const SourceMap& sources) {
    static constexpr const char* label[] = {"error", "warning", "note"};
    const char* kind = label[static_cast<int>(d.severity)];
    if (d.where.file == SourceSpan::nowhere) {
        out += fmt::format("lancer: {}: {}\n", kind, printable(d.message));
    } else {
        const auto [line, column] = sources.locate(d.where);
        out += fmt::format("{}:{}:{}: {}: {}\n", printable(sources.name(d.where.file)), line,
                           column, kind, printable(d.message));
        out += quote(d.where, sources);
    }
    if (!d.hint.empty()) out += fmt::format("    hint: {}\n", printable(d.hint));
    for (const Diagnostic& note : d.notes) append(out, note, sources);
}

}  // namespace

std::string format(const Diagnostic& diagnostic, const SourceMap& sources) {
    std::string out;
    append(out, diagnostic, sources);
    return out;
}

}  // namespace lancer
