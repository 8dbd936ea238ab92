// Statements and expressions that the reader has begun and not ended, in stacks. After a syntax
// error all that was begun since some place is dropped: each stack can report its length and be cut
// to an earlier one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "parser/ast.h"
#include "parser/vocabulary.h"

namespace lancer::grammar {

template <class... Stacks>
std::array<std::size_t, sizeof...(Stacks)> lengths(const std::tuple<Stacks&...>& stacks) {
    return std::apply([](const auto&... stack) { return std::array{stack.size()...}; }, stacks);
}

template <class... Stacks>
void cut(const std::tuple<Stacks&...>& stacks,
         const std::array<std::size_t, sizeof...(Stacks)>& to) {
    std::apply([next = to.begin()](auto&... stack) mutable { (stack.resize(*next++), ...); },
               stacks);
}

struct OpenStatement : ast::Statement, ast::Parts {};

struct OpenStatements {
    /// The file, or a body that is being read.
    struct Context {
        const PropertySet* properties = nullptr;
        bool properties_only = false;
        bool damaged = false;
        bool brace_lost = false;  ///< a string that is not closed contains its `}`
        const char* opener = nullptr;
        std::size_t pending = 0;
    };

    std::vector<OpenStatement> building;  ///< begun statements, the innermost last
    std::vector<ast::Statement> pending;  ///< complete statements of bodies that are still open
    std::vector<Context> contexts;
    std::vector<std::size_t> else_marks;  ///< index into `pending` where each `else` begins

    auto stacks() { return std::tie(building, pending, contexts, else_marks); }
};

struct OpenExpressions {
    struct Operator {
        ast::Op op;
        std::uint8_t precedence;
        const char* begin;
        const char* end;
        std::uint32_t branch;  ///< the step whose jump it ends, for && and ||
    };
    /// The list that is being read.
    struct Listed {
        std::uint32_t count = 0;
        bool gathers = false;  ///< an element of it is computed
    };
    /// A `for` or `if` of a computed list.
    struct Clause {
        ast::Step word;
        Symbol variable = no_symbol;  ///< none for an `if`
        std::uint32_t step = 0;       ///< the step whose payload is not yet set
    };
    /// A block in place: the lengths of the arrays before it.
    struct Skip {
        std::uint32_t step = 0;
        std::size_t arguments = 0, parts = 0, labels = 0;
    };

    std::vector<ast::Expression> values;
    std::vector<Operator> operators;
    std::vector<std::size_t> bases;       ///< index into `operators` where each chain begins
    std::vector<std::uint32_t> branches;  ///< steps of `? :` whose jumps are not yet set
    std::vector<const char*> brackets;
    std::vector<Listed> counts;  ///< of lists and calls
    std::vector<ast::Argument> labels;
    std::vector<ast::Step> callees;
    std::vector<Clause> clauses;
    std::vector<std::size_t> computed;  ///< the first clause of each computed list
    std::vector<Skip> skips;

    auto stacks() {
        return std::tie(values, operators, bases, branches, brackets, counts, labels, callees,
                        clauses, computed, skips);
    }
};

}  // namespace lancer::grammar
