#include "parser/builder.h"

#include <algorithm>

#include "parser/scan.h"

namespace lancer::grammar {

using Kind = ast::Statement::Kind;

Builder::Builder(ast::File& file, std::string_view text, Symbols& symbols,
                 const Vocabulary& vocabulary, std::uint64_t nesting_limit, Report& report)
    : file_(file),
      text_(text),
      symbols_(symbols),
      vocabulary_(vocabulary),
      nesting_limit_(nesting_limit),
      report_(report),
      last_end_(text.data()) {
    open_.contexts.emplace_back().properties = &vocabulary.in_statements();
}

SourceSpan Builder::span(const char* begin, const char* end) const {
    return file_.span(offset_of(begin), static_cast<std::uint32_t>(end - begin));
}

void Builder::deeper(const char* at) {
    if (nesting_ >= nesting_limit_) throw SyntaxError{Message::nesting_limit, at};
    ++nesting_;
}

std::string_view Builder::word_at(const char* at) const {
    const std::string_view rest = text_.substr(offset_of(at));
    if (rest.empty() || !scan::is_name_start(rest[0])) return {};
    std::size_t length = 1;
    while (length < rest.size() && scan::is_name_part(rest[length])) ++length;
    const std::string_view word = rest.substr(0, length);
    return scan::is_reserved(word) ? std::string_view{} : word;
}

bool Builder::knows_property(std::string_view word) {
    return open_.contexts.back().properties->knows(symbols_.intern(word));
}

bool Builder::knows_block(std::string_view word) {
    return vocabulary_.is_block(symbols_.intern(word));
}

bool Builder::block_being_opened_knows(const char*, std::string_view word) {
    const OpenStatement& block = open_.building.back();
    return vocabulary_.properties(block.word, block.name).knows(symbols_.intern(word));
}

std::size_t Builder::blank_length(const char* at) const {
    const std::size_t from = offset_of(at);
    return scan::skip_blanks(text_, from) - from;
}

bool Builder::value_is_left_out(const char* at) {
    const std::string_view word = word_at(at);
    if (word.empty() || !knows_property(word)) return false;
    const auto next = scan::next_token(text_, offset_of(at) + word.size());
    using Token = scan::Token::Kind;
    return next.kind == Token::number || next.kind == Token::string;
}

bool Builder::is_next_block(const char* at) {
    const std::size_t offset = offset_of(at);
    if (offset >= text_.size() || !scan::is_name_start(text_[offset]) ||
        !scan::is_first_on_line(text_, offset))
        return false;
    auto token = scan::next_token(text_, offset);
    if (!knows_block(text_.substr(offset, token.end - offset))) return false;
    token = scan::next_token(text_, token.end);
    if (token.kind == scan::Token::Kind::name) token = scan::next_token(text_, token.end);
    return token.kind == scan::Token::Kind::open_brace;
}

bool Builder::is_outer_statement(const char* at) {
    const Context& context = open_.contexts.back();
    if (!context.properties_only) return false;
    const std::size_t offset = offset_of(at);
    if (offset >= text_.size() || !scan::is_name_start(text_[offset]) ||
        !scan::is_first_on_line(text_, offset))
        return false;
    const auto word = scan::next_token(text_, offset);
    const std::string_view text = text_.substr(offset, word.end - offset);
    if (scan::indentation(text_, offset) > scan::indentation(text_, offset_of(context.opener)))
        return false;
    return scan::begins_statement(text) || (knows_block(text) && !knows_property(text));
}

void Builder::comment(const char* begin, const char* end) {
    const std::uint32_t offset = offset_of(begin);
    // Blanks are read again after a lookahead; count each comment once.
    if (!file_.comments.empty() && file_.comments.back().offset >= offset) return;
    file_.comments.push_back({offset, static_cast<std::uint32_t>(end - begin)});
}

void Builder::begin_statement(Kind kind, const char* begin, const char* end) {
    OpenStatement& statement = open_.building.emplace_back();
    const std::string_view word(begin, static_cast<std::size_t>(end - begin));
    statement.kind = kind;
    statement.word = symbols_.intern(word);
    statement.offset = offset_of(begin);
    statement.length = ast::capped(word.size());
    const auto arguments = static_cast<std::uint32_t>(file_.arguments.size());
    statement.arguments = {arguments, arguments};
}

void Builder::statement_name(const char* begin, const char* end) {
    const std::string_view name(begin, static_cast<std::size_t>(end - begin));
    OpenStatement& statement = open_.building.back();
    statement.name = symbols_.intern(name);
    statement.name_offset = offset_of(begin);
    statement.name_length = static_cast<std::uint32_t>(name.size());
}

void Builder::parameter(const char* begin, const char* end) {
    const std::string_view name(begin, static_cast<std::size_t>(end - begin));
    file_.arguments.push_back(
        {symbols_.intern(name), offset_of(begin), static_cast<std::uint32_t>(name.size()), {}});
}

void Builder::default_value() {
    file_.arguments.back().value = last_value_;
}

void Builder::part() {
    file_.arguments.push_back({no_symbol, 0, 0, last_value_});
}

void Builder::argument() {
    ast::Argument argument;
    // A label from outside of a block in place belongs to the call around that block.
    const std::size_t outside = within_.skips.empty() ? 0 : within_.skips.back().labels;
    if (within_.labels.size() > outside) {
        argument = within_.labels.back();
        within_.labels.pop_back();
    }
    argument.value = last_value_;
    file_.arguments.push_back(argument);
}

void Builder::begin_body() {
    OpenStatement& owner = open_.building.back();
    owner.arguments.end = static_cast<std::uint32_t>(file_.arguments.size());
    Context context;
    context.pending = open_.pending.size();
    context.opener = text_.data() + owner.offset;
    switch (owner.kind) {
        case Kind::block:
            context.properties = &vocabulary_.properties(owner.word, owner.name);
            context.properties_only =
                vocabulary_.is_block(owner.word) && !vocabulary_.holds_statements(owner.word);
            break;
        case Kind::def:
            context.properties = &vocabulary_.in_statements();
            break;
        default:
            context.properties = open_.contexts.back().properties;
            break;
    }
    open_.contexts.push_back(context);
}

ast::Range Builder::flush(std::size_t from) {
    const auto begin = static_cast<std::uint32_t>(file_.statements.size());
    const auto first = open_.pending.begin() + static_cast<std::ptrdiff_t>(from);
    make_room(file_.statements, open_.pending.size());  // the others will follow
    file_.statements.insert(file_.statements.end(), first, open_.pending.end());
    open_.pending.erase(first, open_.pending.end());
    return {begin, static_cast<std::uint32_t>(file_.statements.size())};
}

void Builder::end_body(const char* at, bool closed) {
    Context context = open_.contexts.back();
    open_.contexts.pop_back();
    if (!closed) {
        context.damaged = true;
        if (!cut_short_ && !context.brace_lost) {
            const SourceSpan where = span_of_token(at);
            if (Diagnostic* error =
                    report_.error(Message::missing_close_brace, where, found_at(at))) {
                const ast::Statement& owner = open_.building.back();
                error->notes.push_back(Report::note(Message::opened_here, file_.span(owner)));
            }
            cut_short_ = offset_of(at) >= text_.size();
        }
    }
    last_brace_ = at + (closed ? 1 : 0);
    const ast::Range body = flush(context.pending);
    OpenStatement& owner = open_.building.back();
    owner.damaged |= context.damaged;
    (owner.otherwise ? *owner.otherwise : owner.body) = body;
}

void Builder::begin_else() {
    open_.building.back().otherwise.emplace();
    open_.else_marks.push_back(open_.pending.size());
}

void Builder::end_else() {
    // `else if`: the inner statement alone is the body.
    if (open_.pending.size() > open_.else_marks.back())
        open_.building.back().otherwise = flush(open_.else_marks.back());
    open_.else_marks.pop_back();
}

void Builder::end_statement() {
    OpenStatement& statement = open_.building.back();
    if (statement.body.empty() && statement.kind != Kind::block && statement.kind != Kind::def &&
        statement.kind != Kind::loop && statement.kind != Kind::choice)
        statement.arguments.end = static_cast<std::uint32_t>(file_.arguments.size());
    if (!within_.brackets.empty() && statement.kind == Kind::call) {
        within_.brackets.pop_back();
        within_.counts.pop_back();
    }
    make_room(open_.pending, 1);
    open_.pending.push_back(closed(statement));
    open_.building.pop_back();
}

ast::Statement Builder::closed(const OpenStatement& open) {
    ast::Statement statement = static_cast<const ast::Statement&>(open);
    if (open.name != no_symbol || !open.arguments.empty() || !open.body.empty() || open.otherwise) {
        statement.parts = static_cast<std::uint32_t>(file_.parts.size());
        make_room(file_.parts, 1);
        file_.parts.push_back(open);
    }
    return statement;
}

void Builder::end_file() {
    file_.body = flush(0);
}

}  // namespace lancer::grammar
