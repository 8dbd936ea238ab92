// Rules that need information from the builder: the properties of the block around, the depth of
// nesting, and where to go on after an error.
#pragma once

#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/analyze_traits.hpp>

#include "parser/builder.h"

namespace lancer::grammar {

namespace p = tao::pegtl;

/// Rules that ask the builder whether they match. `ask` does not move the input.
template <class Derived>
struct builder_rule {
    using rule_t = Derived;
    using subs_t = p::type_list<>;

    template <p::apply_mode, p::rewind_mode, template <class...> class, template <class...> class,
              class In>
    static bool match(In& in, Builder& builder) {
        return Derived::test(in, builder);
    }
};

template <class In>
std::uint32_t offset_of(const In& in, const Builder& builder) {
    return builder.offset_of(in.current());
}

/// A name that is a property of the block around.
struct known_property : builder_rule<known_property> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        const std::string_view word = builder.word_at(in.current());
        if (word.empty() || !builder.knows_property(word)) return false;
        in.bump_in_this_line(word.size());
        return true;
    }
};

/// A name that is a property of the block around and not a block's keyword.
struct plain_property : builder_rule<plain_property> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        const std::string_view word = builder.word_at(in.current());
        return !word.empty() && builder.knows_property(word) && !builder.knows_block(word);
    }
};

/// A block on a line of its own where an operand should stand: so the operand is missing.
struct next_block : builder_rule<next_block> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        return builder.is_next_block(in.current());
    }
};

/// A name that is the keyword of some block.
struct known_block : builder_rule<known_block> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        const std::string_view word = builder.word_at(in.current());
        if (word.empty() || !builder.knows_block(word)) return false;
        in.bump_in_this_line(word.size());
        return true;
    }
};

/// A name that is a property of the block whose keyword was just read.
struct property_of_block : builder_rule<property_of_block> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        const std::string_view word = builder.word_at(in.current());
        if (word.empty() || !builder.block_being_opened_knows(in.current(), word)) return false;
        in.bump_in_this_line(word.size());
        return true;
    }
};

/// `{`, or a property in its place: then the missing brace is reported and assumed.
struct block_open_or_property : builder_rule<block_open_or_property> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        if (!in.empty() && *in.current() == '{') {
            in.bump_in_this_line(1);
        } else {
            builder.missing_open_brace(in.current());
        }
        in.bump(builder.blank_length(in.current()));
        return true;
    }
};

/// The name of a property where the value of another should stand, as in `center radius 1`.
struct value_left_out : builder_rule<value_left_out> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        return builder.value_is_left_out(in.current());
    }
};

/// A material or texture in place, where an operand may stand.
struct block_in_place : builder_rule<block_in_place> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        return !in.empty() && (*in.current() == 'm' || *in.current() == 't') &&
               builder.is_block_in_place(in.current());
    }
};

/// A value in the form of another language: a colour after `rgb`, a block in place.
struct foreign_value : builder_rule<foreign_value> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        return builder.is_foreign_value(in.current());
    }
};

/// A statement of another language, such as `while` or `elif`: it is an error, and its body is
/// skipped.
struct foreign_statement : builder_rule<foreign_statement> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        builder.refuse_foreign_statement(in.current());
        return false;
    }
};

/// `# …` where a statement should stand: it is reported, and its line is skipped.
struct stray_hash : builder_rule<stray_hash> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        if (in.empty() || *in.current() != '#') return false;
        in.bump(builder.report_hash(in.current()));
        in.bump(builder.blank_length(in.current()));
        return true;
    }
};

/// `var` before a name and `=`: it is reported and skipped, so that the name counts as declared.
struct stray_declarator : builder_rule<stray_declarator> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        const std::size_t length = builder.report_declarator(in.current());
        if (length == 0) return false;
        in.bump(length);
        return true;
    }
};

/// `=` between a property and its value: it is reported and skipped.
struct stray_equals : builder_rule<stray_equals> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        if (in.empty() || *in.current() != '=') return false;
        builder.report_stray(in.current());
        in.bump_in_this_line(1);
        in.bump(builder.blank_length(in.current()));
        return true;
    }
};

/// `;` or `,` between statements: it is reported and skipped.
struct stray_separator : builder_rule<stray_separator> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        if (in.empty() || (*in.current() != ';' && *in.current() != ',')) return false;
        builder.report_stray(in.current());
        in.bump_in_this_line(1);
        in.bump(builder.blank_length(in.current()));
        return true;
    }
};

/// A `}` that closes nothing: it is reported and skipped.
struct stray_brace : builder_rule<stray_brace> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        if (in.empty() || *in.current() != '}') return false;
        builder.report_stray(in.current());
        in.bump_in_this_line(1);
        in.bump(builder.blank_length(in.current()));
        return true;
    }
};

/// A statement that cannot belong to the block around and is indented less: so the block's `}` is
/// missing.
struct outer_statement : builder_rule<outer_statement> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        return builder.is_outer_statement(in.current());
    }
};

/// `}`. A missing one is reported, with its opening brace, and assumed.
struct body_close : builder_rule<body_close> {
    template <class In>
    static bool test(In& in, Builder& builder) {
        if (!in.empty() && *in.current() == '}') {
            builder.end_body(in.current(), true);
            in.bump_in_this_line(1);
        } else {
            builder.end_body(in.current(), false);
        }
        return true;
    }
};

/// One level of nesting, up to the limit. `First`: the characters with which the rule can begin.
template <class Rule, char... First>
struct nested {
    using rule_t = nested;
    using subs_t = p::type_list<Rule>;

    template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
              template <class...> class Control, class In>
    static bool match(In& in, Builder& builder) {
        if constexpr (sizeof...(First) > 0)
            if (in.empty() || ((*in.current() != First) && ...)) return false;
        const Builder::Nesting level(builder, in.current());
        return Control<Rule>::template match<A, M, Action, Control>(in, builder);
    }
};

/// A statement. After a syntax error in it the builder decides where to go on.
template <class Rule>
struct recovering {
    using rule_t = recovering;
    using subs_t = p::type_list<Rule>;

    template <p::apply_mode A, p::rewind_mode M, template <class...> class Action,
              template <class...> class Control, class In>
    static bool match(In& in, Builder& builder) {
        const Builder::Mark mark = builder.mark(in.current());
        try {
            return Control<Rule>::template match<A, M, Action, Control>(in, builder);
        } catch (const SyntaxError& error) {
            const char* resume = builder.recover(mark, error);
            in.bump(static_cast<std::size_t>(resume - in.current()));
            return true;
        }
    }
};

}  // namespace lancer::grammar

namespace tao::pegtl {

template <class Name, class Derived>
struct analyze_traits<Name, lancer::grammar::builder_rule<Derived>> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::known_property> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::plain_property> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::next_block> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::block_in_place> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::known_block> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::property_of_block> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::block_open_or_property> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::value_left_out> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::stray_equals> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::stray_separator> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::stray_brace> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::foreign_value> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::foreign_statement> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::stray_hash> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::stray_declarator> : analyze_any_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::outer_statement> : analyze_opt_traits<> {};
template <class Name>
struct analyze_traits<Name, lancer::grammar::body_close> : analyze_opt_traits<> {};
template <class Name, class Rule, char... First>
struct analyze_traits<Name, lancer::grammar::nested<Rule, First...>>
    : analyze_traits<Name, typename seq<Rule>::rule_t> {};
template <class Name, class Rule>
struct analyze_traits<Name, lancer::grammar::recovering<Rule>>
    : analyze_traits<Name, typename seq<Rule>::rule_t> {};

}  // namespace tao::pegtl
