// Text that does not belong in a script, with hints about what its author may have meant: stray
// characters between statements, and syntax errors that are habits from other languages.
#include <algorithm>

#include "parser/builder.h"
#include "parser/habits.h"

namespace lancer::grammar {

using Kind = ast::Statement::Kind;
using Token = scan::Token;

/// The last token on the line before `at`; its kind is `end` when there is none.
Token Builder::token_before(std::size_t at) const {
    std::size_t begin = at;
    while (begin > 0 && !scan::is_line_end(text_[begin - 1])) --begin;
    Token last;
    for (Token token = scan::next_token(text_, begin);
         token.kind != Token::Kind::end && token.begin < at;
         token = scan::next_token(text_, token.end))
        last = token;
    return last;
}

/// From `at` to the next `close` on its line; empty where there is none.
std::string_view Builder::until(char close, std::size_t at) const {
    const std::string_view line = text_.substr(at, scan::line_end(text_, at) - at);
    const std::size_t end = line.find(close);
    return end == std::string_view::npos ? std::string_view{} : line.substr(0, end);
}

/// The place where a name that is visible here got its value; `nowhere` when it has none yet.
SourceSpan Builder::place_of_value(Symbol name) const {
    const auto declares = [name](const ast::Statement& s, const ast::Parts& parts) {
        return parts.name == name &&
               (s.kind == Kind::let || s.kind == Kind::param || s.kind == Kind::loop);
    };
    const auto& pending = open_.pending;
    const auto complete =
        std::find_if(pending.rbegin(), pending.rend(),
                     [&](const ast::Statement& s) { return declares(s, file_.parts_of(s)); });
    if (complete != pending.rend()) return file_.name_span(*complete);
    const auto& building = open_.building;
    const auto begun = std::find_if(building.rbegin(), building.rend(),
                                    [&](const OpenStatement& s) { return declares(s, s); });
    if (begun != building.rend()) return name_span(*begun);
    for (const OpenStatement& open : open_.building) {
        for (std::uint32_t i = open.arguments.begin; i < open.arguments.end; ++i)
            if (file_.arguments[i].name == name) return file_.span(file_.arguments[i]);
    }
    return {};
}

/// Reports `name = value` where a property should stand.
void Builder::report_assignment(const char* at) {
    OpenStatement& property = open_.building.back();
    const SourceSpan first = place_of_value(property.word);
    const std::string_view word = symbols_.text(property.word);
    const std::size_t begin = offset_of(at);
    bool names_itself = false;
    const std::size_t end = scan::line_end(text_, begin);
    for (Token token = scan::next_token(text_, begin + 1); token.begin < end;
         token = scan::next_token(text_, token.end))
        names_itself |= text_of(token) == word;
    const bool has_value = first.file != SourceSpan::nowhere;
    Diagnostic* error =
        has_value ? report_.error(Message::values_do_not_change, file_.span(property), word)
                  : report_.error(Message::stray_equals, span(at, at + 1));
    if (error != nullptr) {
        error->hint = has_value || names_itself
                          ? "a value cannot be changed: in a loop, compute values from the loop's "
                            "variable; give another value another name"
                          : "to give a value a name, write 'let " + std::string(word) + " = ...'";
        if (has_value)
            error->notes.insert(error->notes.begin(), Report::note(Message::first_here, first));
    }
    property.kind = Kind::broken;
    property.name = property.word;
}

void Builder::report_stray(const char* at) {
    const SourceSpan where = span(at, at + 1);
    if (*at == '}') {
        report_.error(Message::stray_close_brace, where);
    } else if (*at == '=') {
        OpenStatement& property = open_.building.back();
        if (declarator_end_ == text_.data() + property.offset) {
            property.kind = Kind::broken;
            property.name = property.word;
        } else if (open_.contexts.back().properties->knows(property.word)) {
            report_.error(Message::stray_equals, where);
        } else {
            report_assignment(at);
        }
    } else {
        report_.error(Message::stray_separator, where, std::string_view(at, 1));
    }
}

std::size_t Builder::report_hash(const char* at) {
    const std::size_t begin = offset_of(at);
    const Token word = scan::next_token(text_, begin + 1);
    const std::string_view directive = habits::instead_of_directive(text_of(word));
    Diagnostic* error = report_.error(Message::hash_comment, span(at, at + 1));
    if (error != nullptr)
        error->hint = directive.empty() ? "a comment starts with '//'" : directive;
    return scan::line_end(text_, begin) - begin;
}

std::size_t Builder::report_declarator(const char* at) {
    const std::string_view word = word_at(at);
    if (word.empty() || !habits::declares(word) || knows_property(word)) return 0;
    const std::size_t begin = offset_of(at);
    const Token name = scan::next_token(text_, begin + word.size());
    const Token equals = scan::next_token(text_, name.end);
    if (name.kind != Token::Kind::name || text_of(equals) != "=") return 0;
    if (Diagnostic* error = report_.error(Message::unknown_word, span(at, at + word.size()), word))
        error->hint = "write 'let " + std::string(text_of(name)) + " = ...'";
    declarator_end_ = text_.data() + name.begin;
    return name.begin - begin;
}

bool Builder::is_foreign_value(const char* at) {
    const std::string_view word = word_at(at);
    if (word.empty()) return false;
    Token next = scan::next_token(text_, offset_of(at) + word.size());
    if (next.kind == Token::Kind::open_brace) return knows_block(word) && !is_block_in_place(at);
    if (!habits::announces_color(word)) return false;
    // `rgb[0]` and `rgb < 1` are values; with a comma inside, it is a colour.
    const bool angle = text_of(next) == "<";
    if (!angle && text_of(next) != "[") return false;
    int depth = 0;
    const std::size_t end = scan::line_end(text_, next.begin);
    for (next = scan::next_token(text_, next.end); next.begin < end && depth >= 0;
         next = scan::next_token(text_, next.end)) {
        depth += next.kind == Token::Kind::open ? 1 : next.kind == Token::Kind::close ? -1 : 0;
        if (depth == 0 && text_of(next) == ",") return true;
        if (text_of(next) == "?" || text_of(next) == ">" || next.kind == Token::Kind::open_brace)
            return false;
    }
    return false;
}

void Builder::refuse_foreign_statement(const char* at) {
    const std::string_view word = word_at(at);
    if (word.empty() || !habits::begins_foreign_statement(word) || knows_property(word)) return;
    Token next = scan::next_token(text_, offset_of(at) + word.size());
    if (text_of(next) == "(") {  // a template may be called this way: then no body follows
        for (int depth = 1; depth > 0 && next.kind != Token::Kind::end;) {
            next = scan::next_token(text_, next.end);
            depth += next.kind == Token::Kind::open ? 1 : next.kind == Token::Kind::close ? -1 : 0;
        }
        if (scan::next_token(text_, next.end).kind != Token::Kind::open_brace) return;
    }
    throw SyntaxError{Message::unknown_word, at};
}

/// The hint for a place where a value should stand.
std::string Builder::value_hint(std::size_t at) const {
    const Token token = scan::next_token(text_, at);
    const std::string_view found = text_of(token);
    if (found == "<") return habits::vector_hint(until('>', token.end));
    if (found == "'") {
        const std::string_view inside = until('\'', token.end);
        return "use double quotes around a string: \"" +
               (inside.empty() ? "text" : std::string(inside)) + "\"";
    }
    if (habits::announces_color(found)) {
        const Token open = scan::next_token(text_, token.end);
        return habits::vector_hint(until(text_of(open) == "<" ? '>' : ']', open.end), "a colour",
                                   "red, green, blue");
    }
    if (found == "+" || found == "-" || found == "*" || found == "/")
        return "a value cannot be changed: give another value another name";
    return {};
}

std::string Builder::hint_for(const SyntaxError& error) const {
    const std::size_t at = offset_of(error.at);
    const Token token = scan::next_token(text_, at);
    const std::string_view found = text_of(token);
    const Token before = token_before(token.begin);
    if (const std::string_view hint = habits::about_character(found); !hint.empty())
        return std::string(hint);
    const bool unit = habits::is_unit(found) && before.kind == Token::Kind::number;
    switch (error.message) {
        case Message::expected_member:
            // The dot belongs to the digit before it.
            return at >= 2 && scan::is_digit(text_[at - 2])
                       ? "remove the dot, or write a digit after it"
                       : "";
        case Message::number_runs_on: {
            const Token number = token_before(at);
            const std::string_view runs_on = text_of(number).substr(at - number.begin);
            return habits::is_unit(runs_on) ? std::string(habits::about_unit(runs_on)) : "";
        }
        case Message::color_digits:
            return found.empty() || !scan::is_name_part(text_[at - 1])
                       ? "a comment starts with '//'"
                       : "";
        case Message::unknown_escape:
            return "write '\\\\' for a backslash; in file names '/' works on every system";
        case Message::unknown_word:
            return std::string(habits::instead_of(found));
        case Message::expected_value:
            if (!open_.building.empty() && open_.building.back().kind == Kind::property) {
                const ast::Statement& property = open_.building.back();
                const std::string_view word = symbols_.text(property.word);
                if (token_before(property.offset).kind == Token::Kind::number &&
                    habits::is_unit(word))
                    return std::string(habits::about_unit(word));
            }
            return value_hint(at);
        case Message::expected_expression:
            return found == "if" ? "use 'condition ? one : other' to choose a value"
                                 : value_hint(at);
        case Message::expected_statement:
            return found == "'" ? value_hint(at) : "";
        case Message::expected_paren_close:
            return found == ","
                       ? habits::vector_hint(until(')', offset_of(within_.brackets.back()) + 1))
                       : "";
        case Message::expected_index_close:
            return found == "," ? "brackets after a name take one number: the index of an element"
                                : "";
        case Message::expected_close:
            if (found == "for" && *within_.brackets.back() == '[')
                return "a computed list starts with 'for': " + std::string(habits::computed);
            if (found == ":" && *within_.brackets.back() == '[')
                return "use '0..10' after 'in', or range(0, 10, 1), for a row of numbers";
            if (unit) return std::string(habits::about_unit(found));
            return token.kind == Token::Kind::number || token.kind == Token::Kind::name ||
                           token.kind == Token::Kind::string
                       ? "use commas between the items in brackets"
                       : "";
        case Message::expected_parameters:
            return found == "=" && open_.building.back().kind == Kind::func
                       ? "use 'let' for a value without parameters: 'let " +
                             std::string(symbols_.text(open_.building.back().name)) + " = ...'"
                       : "";
        case Message::expected_equals:
            if (open_.building.back().kind == Kind::func)
                return found == "{" ? std::string(habits::callables) : "";
            return open_.building.back().kind == Kind::param
                       ? "a param needs a default value, which -D on the command line replaces: "
                         "'param " +
                             std::string(symbols_.text(open_.building.back().name)) + " = 1'"
                       : "";
        case Message::expected_element:
            return "a computed list is written " + std::string(habits::computed);
        case Message::expected_name:
        case Message::expected_in:
            if (!within_.computed.empty())
                return "a computed list is written " + std::string(habits::computed);
            return !open_.building.empty() && open_.building.back().kind == Kind::loop
                       ? "use 'for i in 0..10 { ... }' or 'for x in list { ... }' for a loop"
                       : "";
        case Message::expected_open_brace:
            if (found == "=" && open_.building.back().kind == Kind::def)
                return std::string(habits::callables);
            if (found == "and" || found == "or") return std::string(habits::instead_of(found));
            if (text_of(before) == "not") return "write '!" + std::string(found) + "'";
            if (found == ":" || found == "then" || found == "do")
                return "use braces for the statements that follow: { ... }";
            return {};
        default:
            return {};
    }
}

}  // namespace lancer::grammar
