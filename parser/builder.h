// Builds the AST while the grammar reads. It does not depend on PEGTL: the grammar's actions tell
// it what was read, and the grammar's rules ask it what only the context can answer.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "parser/ast.h"
#include "parser/open_parts.h"
#include "parser/report.h"
#include "parser/scan.h"
#include "parser/vocabulary.h"

namespace lancer::grammar {

/// Thrown where the text no longer follows the grammar; caught at the enclosing statement.
struct SyntaxError {
    Message message;
    const char* at;
};

class Builder {
  public:
    Builder(ast::File& file, std::string_view text, Symbols& symbols, const Vocabulary& vocabulary,
            std::uint64_t nesting_limit, Report& report);

    // --- Asked by rules (grammar_rules.h)

    std::uint32_t offset_of(const char* at) const {
        return static_cast<std::uint32_t>(at - text_.data());
    }
    /// The name at `at`; empty where there is none or where it is a reserved word.
    std::string_view word_at(const char* at) const;
    bool knows_property(std::string_view word);
    bool knows_block(std::string_view word);
    bool block_being_opened_knows(const char* at, std::string_view word);
    bool value_is_left_out(const char* at);
    bool is_next_block(const char* at);
    bool is_outer_statement(const char* at);
    /// Length of the blanks and comments from `at` on.
    std::size_t blank_length(const char* at) const;
    void report_stray(const char* at);
    /// Reports a `#` where a statement should stand. Returns the length of the text to skip: the
    /// rest of its line.
    std::size_t report_hash(const char* at);
    /// Reports a word such as `var` before a name and `=`. Returns its length with the blanks
    /// behind it, 0 when there is none.
    std::size_t report_declarator(const char* at);
    /// Whether `material {` or `texture {` stands where a value may. Not in the head of `for` and
    /// `if`, where the brace may open the statement's own body.
    bool is_block_in_place(const char* at);
    /// Whether a colour or a block as another language writes it stands where a value should.
    bool is_foreign_value(const char* at);
    /// Throws where a statement of another language begins.
    void refuse_foreign_statement(const char* at);
    void missing_open_brace(const char* at);
    void end_body(const char* at, bool closed);

    /// One level of nesting while it lives.
    class Nesting {
      public:
        Nesting(Builder& builder, const char* at) : builder_(builder) { builder.deeper(at); }
        ~Nesting() { --builder_.nesting_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;

      private:
        Builder& builder_;
    };

    // --- Recovery

    /// The lengths of all stacks at a place, in the order of the stacks.
    struct Mark {
        const char* at = nullptr;
        std::array<std::size_t, 4> file;
        std::array<std::size_t, 4> statements;
        std::array<std::size_t, 11> expressions;
        std::uint64_t nesting = 0;

        std::size_t building() const { return statements[0]; }
        std::size_t contexts() const { return statements[2]; }
        std::size_t brackets() const { return expressions[4]; }
    };
    Mark mark(const char* at);
    /// Reports the error, drops what was read since the mark, and returns where to go on.
    const char* recover(const Mark& mark, const SyntaxError& error);

    // --- Told by actions (actions.h): expressions

    void comment(const char* begin, const char* end);
    void comment_open(const char* at) { comment_open_ = at; }
    void string_open(const char* at) { string_open_ = at; }
    void number(const char* begin, const char* end);
    void string(const char* begin, const char* end);
    void color(const char* begin, const char* end);
    void boolean(const char* begin, const char* end, bool value);
    void callee(const char* begin, const char* end);
    void plain_name();
    void open_bracket(const char* at);
    void open_list(const char* at);
    void element();
    void label(const char* begin, const char* end);
    void end_labelled();
    void end_list(const char* end);
    void end_call(const char* end);
    void end_index(const char* end);
    void end_parentheses(const char* end);
    void member(const char* begin, const char* end);
    void prefix(const char* at);
    void infix(const char* begin, const char* end);
    void begin_chain() { within_.bases.push_back(within_.operators.size()); }
    void end_chain();
    void question(const char* at);
    void colon(const char* at);
    void end_alternatives();
    void begin_value(const char* at);
    void end_value();
    void begin_in_place(const char* begin, const char* end);
    void end_in_place();
    // builder_computed.cpp
    void begin_computed(const char* at);
    void each_word(const char* begin, const char* end);
    void each_variable(const char* begin, const char* end);
    void each_from();
    void each_range();
    void each_list();
    void only_if();
    void end_clause_value() { last_value_ = take_value(); }
    void end_computed();

    // --- Told by actions: statements

    void begin_statement(ast::Statement::Kind kind, const char* begin, const char* end);
    void statement_name(const char* begin, const char* end);
    void end_parameters() { within_.brackets.pop_back(); }
    void parameter(const char* begin, const char* end);
    void default_value();
    void function_value() { open_.building.back().value = last_value_; }
    void part();
    void argument();
    void begin_body();
    void begin_else();
    void end_else();
    void end_statement();
    /// Called when the file's own statements are complete.
    void end_file();

    ast::Expression last_value() const { return last_value_; }

  private:
    using Context = OpenStatements::Context;
    using Listed = OpenExpressions::Listed;
    using Clause = OpenExpressions::Clause;
    using Skip = OpenExpressions::Skip;

    ast::Expression take_value();
    void emit_each(ast::Op op, const ast::Expression& place);
    void emit_of(ast::Op op, const ast::Expression& place);
    void deeper(const char* at);
    void emit(ast::Op op, const char* begin, const char* end, std::uint64_t payload);
    void pop_operator();
    /// A begun statement that is now complete; its parts go to the file.
    ast::Statement closed(const OpenStatement& open);
    ast::Range flush(std::size_t from);
    /// Reserves room for `more` elements. When the array is full, the new capacity assumes that the
    /// rest of the text is like the part that was read; otherwise a long script would be copied
    /// again and again. The factor is at most eight, so that a beginning that is unlike the rest
    /// does not take too much memory.
    template <class T>
    void make_room(std::vector<T>& read, std::size_t more) const {
        const std::size_t needed = read.size() + more;
        if (needed <= read.capacity()) return;
        const double share =
            static_cast<double>(text_.size()) / (static_cast<double>(offset_of(last_end_)) + 1);
        const double grown = static_cast<double>(needed) * std::clamp(1.05 * share, 1.25, 8.0);
        read.reserve(std::max(needed, static_cast<std::size_t>(grown)));
    }
    /// The arrays of the file that a syntax error cuts.
    auto file_stacks() {
        return std::tie(file_.arguments, file_.steps, file_.statements, file_.parts);
    }
    SourceSpan span(const char* begin, const char* end) const;
    SourceSpan name_span(const OpenStatement& s) const {
        return file_.span(s.name_offset, s.name_length);
    }
    std::string found_at(const char* at) const;
    SourceSpan span_of_token(const char* at) const;
    Diagnostic* report(const Mark& mark, const SyntaxError& error);
    // strays.cpp
    std::string hint_for(const SyntaxError& error) const;
    std::string value_hint(std::size_t at) const;
    std::string_view text_of(const scan::Token& token) const {
        return text_.substr(token.begin, token.end - token.begin);
    }
    scan::Token token_before(std::size_t at) const;
    std::string_view until(char close, std::size_t at) const;
    void report_assignment(const char* at);
    SourceSpan place_of_value(Symbol name) const;

    ast::File& file_;
    std::string_view text_;
    Symbols& symbols_;
    const Vocabulary& vocabulary_;
    std::uint64_t nesting_limit_;
    Report& report_;

    OpenStatements open_;
    OpenExpressions within_;
    ast::Expression last_value_;
    std::uint64_t nesting_ = 0;
    const char* last_brace_ = nullptr;  ///< after the last `}` of a body
    const char* last_end_;              ///< the end of the last token of an expression
    const char* comment_open_ = nullptr;
    const char* string_open_ = nullptr;
    const char* declarator_end_ = nullptr;  ///< where a reported `var` was followed by a name
    bool cut_short_ = false;                ///< the text ended too early, and this was reported
};

}  // namespace lancer::grammar
