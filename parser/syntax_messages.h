// The message for each rule that is used in must<>.
#pragma once

#include "parser/grammar.h"
#include "parser/messages.h"

namespace lancer::grammar {

/// There is no default: a must<> whose rule has no message does not compile.
template <class Rule>
struct message_of;

#define LANCER_SYNTAX_MESSAGE(rule, id)               \
    template <>                                       \
    struct message_of<rule> {                         \
        static constexpr Message value = Message::id; \
    };

// clang-format off
LANCER_SYNTAX_MESSAGE(comment_close_needed,     comment_not_closed)
LANCER_SYNTAX_MESSAGE(number_end_needed,        number_runs_on)
LANCER_SYNTAX_MESSAGE(escape_needed,            unknown_escape)
LANCER_SYNTAX_MESSAGE(string_close_needed,      string_not_closed)
LANCER_SYNTAX_MESSAGE(color_digits_needed,      color_digits)
LANCER_SYNTAX_MESSAGE(member_needed,            expected_member)
LANCER_SYNTAX_MESSAGE(expression_needed,        expected_expression)
LANCER_SYNTAX_MESSAGE(operand_needed,           expected_expression)
LANCER_SYNTAX_MESSAGE(element_needed,           expected_expression)
LANCER_SYNTAX_MESSAGE(list_item_needed,         expected_expression)
LANCER_SYNTAX_MESSAGE(clause_value_needed,      expected_expression)
LANCER_SYNTAX_MESSAGE(function_argument_needed, expected_expression)
LANCER_SYNTAX_MESSAGE(argument_needed,          expected_expression)
LANCER_SYNTAX_MESSAGE(part,                     expected_expression)
LANCER_SYNTAX_MESSAGE(function_value,           expected_expression)
LANCER_SYNTAX_MESSAGE(range_end,                expected_expression)
LANCER_SYNTAX_MESSAGE(value_needed,             expected_expression)
LANCER_SYNTAX_MESSAGE(property_value_needed,    expected_value)
LANCER_SYNTAX_MESSAGE(close_square_needed,      expected_close)
LANCER_SYNTAX_MESSAGE(close_round_needed,       expected_close)
LANCER_SYNTAX_MESSAGE(parameters_close_needed,  expected_close)
LANCER_SYNTAX_MESSAGE(paren_close_needed,       expected_paren_close)
LANCER_SYNTAX_MESSAGE(index_close_needed,       expected_index_close)
LANCER_SYNTAX_MESSAGE(colon_needed,             expected_colon)
LANCER_SYNTAX_MESSAGE(declared_name_needed,     expected_name)
LANCER_SYNTAX_MESSAGE(parameter_needed,         expected_name)
LANCER_SYNTAX_MESSAGE(each_variable_needed,     expected_name)
LANCER_SYNTAX_MESSAGE(each_in_needed,           expected_in)
LANCER_SYNTAX_MESSAGE(computed_colon_needed,    expected_element)
LANCER_SYNTAX_MESSAGE(equals_needed,            expected_equals)
LANCER_SYNTAX_MESSAGE(parameters_needed,        expected_parameters)
LANCER_SYNTAX_MESSAGE(in_needed,                expected_in)
LANCER_SYNTAX_MESSAGE(block_open_needed,        expected_open_brace)
LANCER_SYNTAX_MESSAGE(statement_needed,         expected_statement)
LANCER_SYNTAX_MESSAGE(lone_end_needed,          after_definition)
// clang-format on

#undef LANCER_SYNTAX_MESSAGE

/// PEGTL's control class: a must<> that fails throws our own error, which has its place without
/// counting lines.
template <class Rule>
struct control : p::normal<Rule> {
    template <class In>
    [[noreturn]] static void raise(const In& in, Builder&) {
        throw SyntaxError{message_of<Rule>::value, in.current()};
    }
};

}  // namespace lancer::grammar
