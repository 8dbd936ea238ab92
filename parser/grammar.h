// The grammar of the scene language, in the order of docs/language.md. The messages are in
// syntax_messages.h, the actions in actions.h. No rule names a shape, light or material.
//
// A rule whose name ends in _needed is used only in must<>: any other text there is an error.
#pragma once

#include <algorithm>
#include <string_view>
#include <tao/pegtl.hpp>

#include "parser/grammar_rules.h"
#include "parser/scan.h"

namespace lancer::grammar {

// clang-format off

// --- 1. Characters, comments, words ------------------------------------------------------------

struct blank                : p::plus<p::one<' ', '\t', '\n', '\r', '\f', '\v'>> {};
struct line_comment         : p::seq<p::string<'/', '/'>, p::star<p::not_one<'\n', '\r'>>> {};
struct comment_open         : p::string<'/', '*'> {};
struct comment_close_needed : p::until<p::string<'*', '/'>> {};
struct block_comment        : p::seq<comment_open, p::must<comment_close_needed>> {};
struct ws                   : p::star<p::sor<blank, line_comment, block_comment>> {};

template <class Text> struct word : p::seq<Text, p::not_at<p::identifier_other>> {};

struct include_word : word<TAO_PEGTL_STRING("include")> {};
struct let_word     : word<TAO_PEGTL_STRING("let")> {};
struct param_word   : word<TAO_PEGTL_STRING("param")> {};
struct def_word     : word<TAO_PEGTL_STRING("def")> {};
struct func_word    : word<TAO_PEGTL_STRING("func")> {};
struct for_word     : word<TAO_PEGTL_STRING("for")> {};
struct in_word      : word<TAO_PEGTL_STRING("in")> {};
struct if_word      : word<TAO_PEGTL_STRING("if")> {};
struct else_word    : word<TAO_PEGTL_STRING("else")> {};
struct assert_word  : word<TAO_PEGTL_STRING("assert")> {};
struct print_word   : word<TAO_PEGTL_STRING("print")> {};
struct true_word    : word<TAO_PEGTL_STRING("true")> {};
struct false_word   : word<TAO_PEGTL_STRING("false")> {};

// The first letter alone rules out most words.
template <char... Letters> struct letter : p::one<Letters...> {
    static constexpr bool begins(std::string_view word) { return ((word[0] == Letters) || ...); }
};
struct reserved_letter : letter<'i', 'l', 'p', 'd', 'f', 'e', 'a', 't'> {};
static_assert(std::all_of(scan::reserved_words.begin(), scan::reserved_words.end(), reserved_letter::begins));

struct reserved : p::seq<p::at<reserved_letter>,
                         p::sor<include_word, in_word, if_word, let_word, param_word, print_word,
                                def_word, for_word, func_word, false_word, else_word, assert_word, true_word>> {};
struct name     : p::seq<p::not_at<reserved>, p::identifier> {};

struct open_round   : p::one<'('> {};
struct open_square  : p::one<'['> {};
struct open_curly   : p::one<'{'> {};
struct close_curly  : p::one<'}'> {};
struct comma        : p::seq<p::one<','>, ws> {};

// --- 2. Literals -------------------------------------------------------------------------------

struct digits            : p::plus<p::digit> {};
struct mantissa          : p::sor<p::seq<digits, p::opt<p::one<'.'>, digits>>,
                                  p::seq<p::one<'.'>, digits>> {};
struct exponent          : p::seq<p::one<'e', 'E'>, p::opt<p::one<'+', '-'>>, digits> {};
struct number_text       : p::seq<mantissa, p::opt<exponent>> {};
struct number_end_needed : p::not_at<p::identifier_other> {};
struct number            : p::seq<number_text, p::must<number_end_needed>> {};

struct escape_needed      : p::one<'n', 't', '"', '\\'> {};
struct string_part        : p::sor<p::if_must<p::one<'\\'>, escape_needed>,
                                   p::not_one<'"', '\n', '\r'>> {};
struct string_close_needed: p::one<'"'> {};
struct string_open        : p::one<'"'> {};
struct string             : p::seq<string_open, p::star<string_part>, p::must<string_close_needed>> {};

struct color_digits_needed: p::seq<p::rep<6, p::xdigit>, p::not_at<p::identifier_other>> {};
struct color              : p::if_must<p::one<'#'>, color_digits_needed> {};

// --- 3. Expressions ----------------------------------------------------------------------------
// One flat chain of operands and operators. A table (operators.h) has their precedence.

struct body;
struct expression;
struct expression_needed : p::seq<expression> {};
// the first position of an expression that a statement owns
struct value_begin       : p::success {};
struct value             : p::seq<value_begin, expression> {};
struct value_needed      : p::seq<value> {};

struct close_square_needed : p::one<']'> {};
struct close_round_needed  : p::one<')'> {};
struct element             : p::seq<expression> {};
struct element_needed      : p::seq<element> {};
struct list_close          : p::one<']'> {};

struct clause_value        : p::seq<value_begin, expression> {};
struct clause_value_needed : p::seq<clause_value> {};
struct each_word           : word<TAO_PEGTL_STRING("for")> {};
struct each_variable       : p::seq<name> {};
struct each_variable_needed: p::seq<each_variable> {};
struct each_in_needed      : p::seq<in_word> {};
struct each_from           : p::two<'.'> {};   // the expression before it is a bound
struct each_range          : p::seq<each_from, ws, p::must<clause_value_needed>> {};
struct each_list           : p::success {};
struct each                : p::seq<each_word, ws, p::must<each_variable_needed>, ws, p::must<each_in_needed>,
                                    ws, p::must<clause_value_needed>, p::sor<each_range, each_list>> {};
struct only_word           : word<TAO_PEGTL_STRING("if")> {};
struct only                : p::seq<only_word, ws, p::must<clause_value_needed>> {};
struct computed_begin      : p::at<each_word> {};
struct computed_colon_needed : p::one<':'> {};
struct computed            : p::seq<computed_begin, p::plus<p::sor<each, only>>,
                                    p::must<computed_colon_needed>, ws, p::must<expression_needed>> {};

struct list_item           : p::sor<computed, element> {};
struct list_item_needed    : p::seq<list_item> {};
struct list                : p::seq<open_square, ws,
                                 p::sor<list_close,
                                        p::seq<p::must<list_item_needed>,
                                               p::star<comma, p::must<list_item_needed>>,
                                               p::must<close_square_needed>>>> {};

struct paren_open          : p::one<'('> {};
struct paren_close_needed  : p::one<')'> {};
struct parenthesised       : p::seq<paren_open, ws, p::must<expression_needed>,
                                    p::must<paren_close_needed>> {};

struct argument_name       : p::seq<name> {};
struct argument_label      : p::seq<p::at<name, ws, p::one<':'>>, argument_name, ws, p::one<':'>, ws> {};

struct callee              : p::seq<name> {};
struct labelled            : p::seq<argument_label, p::must<element_needed>> {};
struct function_argument   : p::sor<labelled, element> {};
struct function_argument_needed : p::seq<function_argument> {};
struct call_open           : p::one<'('> {};
struct call_close          : p::one<')'> {};
struct function_call       : p::seq<call_open, ws,
                                 p::sor<call_close,
                                        p::seq<p::must<function_argument_needed>,
                                               p::star<comma, p::must<function_argument_needed>>,
                                               p::must<close_round_needed>>>> {};
struct plain_name          : p::success {};
struct name_or_call        : p::seq<p::not_at<next_block>, callee, ws, p::sor<nested<function_call, '('>, plain_name>> {};

struct in_place_word       : p::seq<name> {};
struct in_place_braces     : p::seq<open_curly, ws, body> {};
struct in_place            : p::seq<block_in_place, in_place_word, ws, nested<in_place_braces>> {};

struct primary : p::sor<number, in_place, name_or_call, nested<list, '['>, nested<parenthesised, '('>, string, color,
                        true_word, false_word> {};

struct component           : p::seq<p::one<'x', 'y', 'z'>, p::not_at<p::identifier_other>> {};
struct member_needed       : p::at<ws, component> {};   // lookahead, so that an error is reported at the dot
struct member              : p::seq<p::one<'.'>, p::not_at<p::one<'.'>>, p::must<member_needed>, ws, component> {};
struct index_open          : p::one<'['> {};
struct index_close_needed  : p::one<']'> {};
struct index               : p::seq<index_open, ws, p::must<expression_needed>,
                                    p::must<index_close_needed>> {};
struct postfix             : p::seq<p::sor<member, nested<index, '['>>, ws> {};

struct prefix  : p::one<'-', '!'> {};
struct operand : p::seq<p::star<prefix, ws>, primary, ws, p::star<postfix>> {};
struct operand_needed : p::seq<operand> {};
struct infix   : p::sor<p::two<'|'>, p::two<'&'>, p::two<'='>, p::string<'!', '='>,
                        p::string<'<', '='>, p::string<'>', '='>,
                        p::one<'<', '>', '+', '-', '*', '/', '%', '^'>> {};

struct chain_begin  : p::success {};
struct chain        : p::seq<chain_begin, operand, p::star<infix, ws, p::must<operand_needed>>> {};
struct question     : p::one<'?'> {};
struct colon_needed : p::one<':'> {};
struct alternatives : p::seq<question, ws, p::must<expression_needed>, p::must<colon_needed>, ws,
                             p::must<expression_needed>> {};
struct conditional  : p::seq<chain, p::opt<nested<alternatives, '?'>>> {};
struct expression   : p::seq<conditional> {};

// --- 4. Statements -----------------------------------------------------------------------------

struct declared_name        : p::seq<name> {};
struct declared_name_needed : p::seq<declared_name> {};
struct equals_needed        : p::seq<p::one<'='>, ws> {};

struct block_open_needed : p::seq<open_curly, ws> {};
struct braces            : p::seq<p::must<block_open_needed>, body> {};

struct include_statement : p::seq<include_word, ws, p::must<value_needed>> {};
struct let_statement     : p::seq<let_word, ws, p::must<declared_name_needed>, ws,
                                  p::must<equals_needed>, p::must<value_needed>> {};
struct param_statement   : p::seq<param_word, ws, p::must<declared_name_needed>, ws,
                                  p::must<equals_needed>, p::must<value_needed>> {};

struct parameter_name    : p::seq<name> {};
struct default_value     : p::seq<p::one<'='>, ws, p::must<value_needed>> {};
struct parameter         : p::seq<parameter_name, ws, p::opt<default_value>> {};
struct parameter_needed  : p::seq<parameter> {};
struct parameters_needed : p::seq<open_round, ws> {};
struct parameters_close_needed : p::one<')'> {};
struct parameters        : p::seq<p::must<parameters_needed>,
                                  p::sor<p::one<')'>,
                                         p::seq<p::must<parameter_needed>,
                                                p::star<comma, p::must<parameter_needed>>,
                                                p::must<parameters_close_needed>>>> {};
struct def_statement     : p::seq<def_word, ws, p::must<declared_name_needed>, ws, parameters, ws,
                                  nested<braces>> {};

struct function_value    : p::seq<value_needed> {};
struct func_statement    : p::seq<func_word, ws, p::must<declared_name_needed>, ws, parameters, ws,
                                  p::must<equals_needed>, p::must<function_value>> {};

struct loop_end      : p::success {};
struct range_end     : p::seq<value_needed> {};
struct range         : p::seq<p::two<'.'>, ws, p::must<range_end>> {};
struct in_needed     : p::seq<in_word> {};
struct for_statement : p::seq<for_word, ws, p::must<declared_name_needed>, ws, p::must<in_needed>, ws,
                              p::must<value_needed>, p::opt<range>, nested<braces>> {};

struct if_statement;
struct else_branch   : p::sor<nested<if_statement, 'i'>, nested<braces>> {};
struct else_begin    : p::success {};
struct if_statement  : p::seq<if_word, ws, p::must<value_needed>, nested<braces>,
                              p::opt<else_word, ws, else_begin, else_branch>> {};

struct message_begin     : p::success {};
struct part              : p::seq<value_needed> {};
struct assert_statement  : p::seq<assert_word, ws, p::must<value_needed>, p::opt<comma, p::must<part>>> {};
struct print_statement   : p::seq<print_word, ws, p::must<part>, p::star<comma, p::must<part>>> {};

struct argument          : p::seq<p::opt<argument_label>, value> {};
struct argument_needed   : p::seq<argument> {};
struct arguments         : p::seq<call_open, ws,
                               p::sor<p::one<')'>,
                                      p::seq<p::must<argument_needed>,
                                             p::star<comma, p::must<argument_needed>>,
                                             p::must<close_round_needed>>>> {};
struct template_name     : p::seq<name> {};
struct call_statement    : p::seq<p::at<name, ws, open_round>, p::not_at<known_property>,
                                  template_name, ws, nested<arguments, '('>, ws> {};

struct block_word        : p::seq<name> {};
struct block_name        : p::seq<name> {};
struct block_head        : p::seq<name, ws, p::opt<name, ws>, open_curly> {};
struct block_braces      : p::seq<open_curly, ws, body> {};
struct whole_block       : p::seq<p::at<block_head>, p::not_at<plain_property>, block_word, ws, p::opt<block_name, ws>,
                                  nested<block_braces>> {};
struct loose_braces      : p::seq<block_open_or_property, body> {};
struct headless_block    : p::seq<p::at<known_block, ws, p::not_at<open_round>>, p::not_at<known_property>, block_word, ws,
                                  p::opt<p::not_at<property_of_block>, block_name, ws>,
                                  nested<loose_braces>> {};
struct block             : p::sor<whole_block, headless_block> {};

struct property_name     : p::seq<name> {};
struct property_value    : p::seq<p::not_at<value_left_out>, p::not_at<foreign_value>, value> {};
struct property_value_needed : p::seq<property_value> {};
struct property          : p::seq<property_name, ws, p::opt<stray_equals>,
                                  p::must<property_value_needed>> {};

struct statement : p::sor<foreign_statement, include_statement, let_statement, param_statement, def_statement,
                          func_statement, for_statement, if_statement, assert_statement, print_statement, block,
                          call_statement, property> {};
struct statement_needed : p::seq<statement> {};
struct stray            : p::sor<stray_separator, stray_hash, stray_declarator> {};

struct body_begin : p::success {};
struct body : p::seq<body_begin,
                     p::until<p::at<p::sor<close_curly, p::eof, outer_statement>>,
                              p::sor<stray, recovering<p::must<statement_needed>>>>,
                     body_close, ws> {};

// --- 5. Files ----------------------------------------------------------------------------------

struct file_body : p::until<p::eof, p::sor<stray, stray_brace,
                                           recovering<p::must<statement_needed>>>> {};
struct file      : p::seq<recovering<ws>, file_body> {};

/// The value of -D name=value.
struct lone_end_needed   : p::eof {};
struct lone_expression   : p::seq<ws, p::must<value_needed>, p::must<lone_end_needed>> {};

// clang-format on

}  // namespace lancer::grammar
