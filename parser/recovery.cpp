// The builder's part for syntax errors: reports what was expected, and finds the next statement of
// the same depth.
#include <algorithm>

#include "model/utf8.h"
#include "parser/builder.h"
#include "parser/scan.h"

namespace lancer::grammar {

using Kind = ast::Statement::Kind;
using Token = scan::Token;

/// The token at `at`, for a message; at the end of the text, the last token before it.
SourceSpan Builder::span_of_token(const char* at) const {
    const Token token = scan::next_token(text_, offset_of(at));
    if (token.kind != Token::Kind::end)
        return file_.span(static_cast<std::uint32_t>(token.begin),
                          static_cast<std::uint32_t>(token.end - token.begin));
    std::size_t last = text_.size();
    while (last > 0 && scan::is_blank(text_[last - 1])) --last;
    return file_.span(static_cast<std::uint32_t>(last), 0);
}

std::string Builder::found_at(const char* at) const {
    constexpr std::size_t longest = 30;
    const Token token = scan::next_token(text_, offset_of(at));
    if (token.kind == Token::Kind::end) return "the end of the file";
    std::string_view text = text_.substr(token.begin, token.end - token.begin);
    if (static_cast<unsigned char>(text[0]) < ' ') return "a control character";
    if (text.size() <= longest) return "'" + std::string(text) + "'";
    std::size_t cut = longest;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;
    return "'" + std::string(text.substr(0, cut)) + "...'";
}

void Builder::missing_open_brace(const char* at) {
    const std::string_view word = word_at(at);
    if (word.empty() || !block_being_opened_knows(at, word))
        throw SyntaxError{Message::expected_open_brace, at};
    report_.error(Message::expected_open_brace, span_of_token(at), found_at(at));
}

Builder::Mark Builder::mark(const char* at) {
    return {at, lengths(file_stacks()), lengths(open_.stacks()), lengths(within_.stacks()),
            nesting_};
}

Diagnostic* Builder::report(const Mark& mark, const SyntaxError& error) {
    // Invalid UTF-8 has been reported already.
    const std::size_t stop = scan::skip_blanks(text_, offset_of(error.at));
    if (stop < text_.size() && find_invalid_utf8(text_.substr(0, stop + 1), stop) == stop &&
        find_invalid_utf8(text_, stop) == stop)
        return nullptr;
    const SourceSpan where = span_of_token(error.at);
    const std::string found = found_at(error.at);
    Diagnostic* said = nullptr;
    switch (error.message) {
        case Message::comment_not_closed:
            // When the comment directly follows a word, no blank has recorded where it opens.
            if (comment_open_ == nullptr) {
                const std::size_t open = text_.rfind("/*", offset_of(error.at));
                comment_open_ = open == std::string_view::npos ? error.at : text_.data() + open;
            }
            cut_short_ = true;
            return report_.error(
                error.message,
                span(comment_open_, std::min(comment_open_ + 2, text_.data() + text_.size())));
        case Message::string_not_closed:
            open_.contexts[mark.contexts() - 1].brace_lost =
                std::find(string_open_, error.at, '}') != error.at;
            return report_.error(error.message, span(string_open_, error.at));
        case Message::unknown_escape:
            return report_.error(error.message, span(error.at - 1, error.at + 1));
        case Message::expected_member:
            return report_.error(error.message, span(error.at - 1, error.at));
        case Message::color_digits:
            return report_.error(error.message,
                                 span(std::find(std::make_reverse_iterator(error.at),
                                                std::make_reverse_iterator(text_.data()), '#')
                                              .base() -
                                          1,
                                      error.at));
        case Message::nesting_limit:
            return report_.error(error.message, where, nesting_limit_);
        case Message::unknown_word:
            return report_.error(error.message, where, text_.substr(where.offset, where.length));
        case Message::expected_value: {
            const bool property = open_.building.size() > mark.building() &&
                                  open_.building.back().kind == Kind::property;
            if (!property) return report_.error(Message::expected_expression, where, found);
            const ast::Statement& s = open_.building.back();
            said = report_.error(error.message, where, symbols_.text(s.word), found);
            if (said != nullptr && value_is_left_out(error.at)) said->where = file_.span(s);
            return said;
        }
        case Message::expected_close:
            said = report_.error(error.message, where, *within_.brackets.back() == '[' ? ']' : ')',
                                 found);
            break;
        case Message::expected_index_close:
        case Message::expected_paren_close:
            said = report_.error(error.message, where, found);
            break;
        case Message::expected_equals: {
            // If a line ends without a value, the error is on that line, not on the next.
            const SourceSpan name = name_span(open_.building.back());
            const std::size_t line_end = scan::line_end(text_, name.offset);
            return where.offset >= line_end ? report_.error(Message::value_missing, name,
                                                            text_.substr(name.offset, name.length))
                                            : report_.error(error.message, where, found);
        }
        case Message::expected_parameters:
            return report_.error(error.message, where,
                                 open_.building.back().kind == Kind::func ? "function" : "template",
                                 found);
        case Message::expected_name:
            if (where.length > 0 && scan::is_reserved(text_.substr(where.offset, where.length)))
                return report_.error(Message::name_reserved, where,
                                     text_.substr(where.offset, where.length));
            return report_.error(error.message, where, found);
        default:
            return report_.error(error.message, where, found);
    }
    if (said != nullptr && within_.brackets.size() > mark.brackets())
        said->notes.insert(said->notes.begin(),
                           Report::note(Message::opened_here, span(within_.brackets.back(),
                                                                   within_.brackets.back() + 1)));
    return said;
}

const char* Builder::recover(const Mark& mark, const SyntaxError& error) {
    if (Diagnostic* said = report(mark, error)) said->hint = hint_for(error);
    // The names that a broken statement declares count as declared, so that no errors follow from
    // it.
    const bool in_statement = open_.building.size() > mark.building();
    OpenStatement broken;
    if (in_statement) broken = open_.building[mark.building()];
    cut(file_stacks(), mark.file);
    cut(open_.stacks(), mark.statements);
    cut(within_.stacks(), mark.expressions);
    open_.contexts.back().damaged = true;
    if (in_statement && broken.name != no_symbol && broken.kind != Kind::loop) {
        // Its value and other parts are cut.
        broken.kind = Kind::broken;
        broken.value = {};
        broken.arguments = broken.body = {};
        broken.otherwise.reset();
        open_.pending.push_back(closed(broken));
    }
    nesting_ = mark.nesting;
    if (error.message == Message::comment_not_closed) return text_.data() + text_.size();

    const PropertySet& known = *open_.contexts.back().properties;
    const bool statements = !open_.contexts.back().properties_only;
    const std::size_t start = scan::skip_blanks(text_, offset_of(mark.at));
    // A reserved word in place of a name does not begin the next statement.
    const bool is_word =
        (error.message == Message::expected_name && span_of_token(error.at).length > 1) ||
        (error.message == Message::expected_value && is_foreign_value(error.at));
    // A statement of another language is skipped to the end of its line or body. So is a condition
    // with more text after it.
    const bool whole_line =
        error.message == Message::unknown_word || error.message == Message::expected_open_brace;
    const std::size_t stop = offset_of(error.at) + (is_word ? 1 : 0);
    std::size_t brackets = 0;
    std::size_t braces = 0;
    Token token = scan::next_token(text_, start);
    Token::Kind before = Token::Kind::end;
    for (; token.kind != Token::Kind::end; token = scan::next_token(text_, token.end)) {
        const bool past = token.begin >= stop && token.begin > start;
        switch (token.kind) {
            case Token::Kind::open:
                ++brackets;
                break;
            case Token::Kind::close:
                brackets -= brackets > 0;
                break;
            case Token::Kind::open_brace:
                ++braces;
                break;
            case Token::Kind::close_brace:
                if (past && braces == 0) return text_.data() + token.begin;
                braces -= braces > 0;
                if (braces == 0 && token.end > stop) {
                    Token next = scan::next_token(text_, token.end);
                    for (; brackets > 0 && next.kind == Token::Kind::close; --brackets)
                        next = scan::next_token(text_, next.end);
                    if (text_.substr(next.begin, next.end - next.begin) != "else")
                        return text_.data() + next.begin;
                }
                break;
            case Token::Kind::name: {
                if (!past || braces > 0) break;
                if (whole_line && !scan::is_first_on_line(text_, token.begin)) break;
                const std::string_view word = text_.substr(token.begin, token.end - token.begin);
                // Within brackets, `for` and `if` belong to a computed list.
                if (brackets > 0 && (word == "for" || word == "if") &&
                    !scan::is_first_on_line(text_, token.begin))
                    break;
                if (scan::begins_statement(word)) return text_.data() + token.begin;
                if (scan::is_reserved(word)) break;
                const Token next = scan::next_token(text_, token.end);
                const bool value_follows =
                    next.kind == Token::Kind::number || next.kind == Token::Kind::string ||
                    next.kind == Token::Kind::name ||
                    (next.kind == Token::Kind::open && text_[next.begin] == '[');
                const bool first = scan::is_first_on_line(text_, token.begin);
                const bool is_known = known.knows(symbols_.intern(word));
                const bool after_operand =
                    before != Token::Kind::other && before != Token::Kind::open;
                const bool opens_block =
                    next.kind == Token::Kind::open_brace ||
                    (next.kind == Token::Kind::name && knows_block(word) && !is_known);
                if ((statements && opens_block) || (is_known && (brackets == 0 || value_follows)) ||
                    (brackets == 0 && (first || (value_follows && after_operand))))
                    return text_.data() + token.begin;
                break;
            }
            default:
                break;
        }
        before = token.kind;
    }
    return text_.data() + text_.size();
}

}  // namespace lancer::grammar
