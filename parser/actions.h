// The grammar's actions: what each rule tells the builder, one line per rule.
#pragma once

#include "parser/builder.h"
#include "parser/grammar.h"

namespace lancer::grammar {

template <class Rule>
struct action : p::nothing<Rule> {};

/// Calls a member of the builder with the first and last position of the matched text.
template <void (Builder::*member)(const char*, const char*)>
struct tell {
    template <class In>
    static void apply(const In& in, Builder& builder) {
        (builder.*member)(in.begin(), in.end());
    }
};
/// Calls it with the first position only.
template <void (Builder::*member)(const char*)>
struct tell_begin {
    template <class In>
    static void apply(const In& in, Builder& builder) {
        (builder.*member)(in.begin());
    }
};
/// Calls it with the last position only.
template <void (Builder::*member)(const char*)>
struct tell_end {
    template <class In>
    static void apply(const In& in, Builder& builder) {
        (builder.*member)(in.end());
    }
};
/// Calls it without arguments.
template <void (Builder::*member)()>
struct tell_that {
    static void apply0(Builder& builder) { (builder.*member)(); }
};
template <ast::Statement::Kind kind>
struct begin {
    template <class In>
    static void apply(const In& in, Builder& builder) {
        builder.begin_statement(kind, in.begin(), in.end());
    }
};
template <bool value>
struct tell_boolean {
    template <class In>
    static void apply(const In& in, Builder& builder) {
        builder.boolean(in.begin(), in.end(), value);
    }
};

using Kind = ast::Statement::Kind;

// clang-format off
template <> struct action<in_place_word>  : tell<&Builder::begin_in_place> {};
template <> struct action<in_place>       : tell_that<&Builder::end_in_place> {};
template <> struct action<line_comment>   : tell<&Builder::comment> {};
template <> struct action<block_comment>  : tell<&Builder::comment> {};
template <> struct action<comment_open>   : tell_begin<&Builder::comment_open> {};

template <> struct action<number_text>    : tell<&Builder::number> {};
template <> struct action<string_open>    : tell_begin<&Builder::string_open> {};
template <> struct action<string>         : tell<&Builder::string> {};
template <> struct action<color>          : tell<&Builder::color> {};
template <> struct action<callee>         : tell<&Builder::callee> {};
template <> struct action<plain_name>     : tell_that<&Builder::plain_name> {};
template <> struct action<open_square>    : tell_begin<&Builder::open_list> {};
template <> struct action<list>           : tell_end<&Builder::end_list> {};
template <> struct action<element>        : tell_that<&Builder::element> {};
template <> struct action<clause_value>   : tell_that<&Builder::end_clause_value> {};
template <> struct action<computed_begin> : tell_begin<&Builder::begin_computed> {};
template <> struct action<each_word>      : tell<&Builder::each_word> {};
template <> struct action<each_variable>  : tell<&Builder::each_variable> {};
template <> struct action<each_from>      : tell_that<&Builder::each_from> {};
template <> struct action<each_range>     : tell_that<&Builder::each_range> {};
template <> struct action<each_list>      : tell_that<&Builder::each_list> {};
template <> struct action<only>           : tell_that<&Builder::only_if> {};
template <> struct action<computed>       : tell_that<&Builder::end_computed> {};
template <> struct action<call_open>      : tell_begin<&Builder::open_list> {};
template <> struct action<function_call>  : tell_end<&Builder::end_call> {};
template <> struct action<argument_name>  : tell<&Builder::label> {};
template <> struct action<labelled>       : tell_that<&Builder::end_labelled> {};
template <> struct action<paren_open>     : tell_begin<&Builder::open_bracket> {};
template <> struct action<parenthesised>  : tell_end<&Builder::end_parentheses> {};
template <> struct action<index_open>     : tell_begin<&Builder::open_bracket> {};
template <> struct action<index>          : tell_end<&Builder::end_index> {};
template <> struct action<member>         : tell<&Builder::member> {};
template <> struct action<prefix>         : tell_begin<&Builder::prefix> {};
template <> struct action<infix>          : tell<&Builder::infix> {};
template <> struct action<chain_begin>    : tell_that<&Builder::begin_chain> {};
template <> struct action<chain>          : tell_that<&Builder::end_chain> {};
template <> struct action<question>       : tell_begin<&Builder::question> {};
template <> struct action<colon_needed>   : tell_begin<&Builder::colon> {};
template <> struct action<alternatives>   : tell_that<&Builder::end_alternatives> {};
template <> struct action<value_begin>    : tell_begin<&Builder::begin_value> {};
template <> struct action<value>          : tell_that<&Builder::end_value> {};

template <> struct action<include_word>   : begin<Kind::include> {};
template <> struct action<let_word>       : begin<Kind::let> {};
template <> struct action<param_word>     : begin<Kind::param> {};
template <> struct action<def_word>       : begin<Kind::def> {};
template <> struct action<func_word>      : begin<Kind::func> {};
template <> struct action<for_word>       : begin<Kind::loop> {};
template <> struct action<if_word>        : begin<Kind::choice> {};
template <> struct action<assert_word>    : begin<Kind::assertion> {};
template <> struct action<print_word>     : begin<Kind::print> {};
template <> struct action<block_word>     : begin<Kind::block> {};
template <> struct action<template_name>  : begin<Kind::call> {};
template <> struct action<property_name>  : begin<Kind::property> {};
template <> struct action<true_word>      : tell_boolean<true> {};
template <> struct action<false_word>     : tell_boolean<false> {};

template <> struct action<declared_name>  : tell<&Builder::statement_name> {};
template <> struct action<block_name>     : tell<&Builder::statement_name> {};
template <> struct action<parameters_needed> : tell_begin<&Builder::open_bracket> {};
template <> struct action<parameters>     : tell_that<&Builder::end_parameters> {};
template <> struct action<parameter_name> : tell<&Builder::parameter> {};
template <> struct action<default_value>  : tell_that<&Builder::default_value> {};
template <> struct action<function_value> : tell_that<&Builder::function_value> {};
template <> struct action<part>           : tell_that<&Builder::part> {};
template <> struct action<range_end>      : tell_that<&Builder::part> {};
template <> struct action<argument>       : tell_that<&Builder::argument> {};
template <> struct action<body_begin>     : tell_that<&Builder::begin_body> {};
template <> struct action<else_begin>     : tell_that<&Builder::begin_else> {};
template <> struct action<else_branch>    : tell_that<&Builder::end_else> {};

template <> struct action<include_statement> : tell_that<&Builder::end_statement> {};
template <> struct action<let_statement>     : tell_that<&Builder::end_statement> {};
template <> struct action<param_statement>   : tell_that<&Builder::end_statement> {};
template <> struct action<def_statement>     : tell_that<&Builder::end_statement> {};
template <> struct action<func_statement>    : tell_that<&Builder::end_statement> {};
template <> struct action<for_statement>     : tell_that<&Builder::end_statement> {};
template <> struct action<if_statement>      : tell_that<&Builder::end_statement> {};
template <> struct action<assert_statement>  : tell_that<&Builder::end_statement> {};
template <> struct action<print_statement>   : tell_that<&Builder::end_statement> {};
template <> struct action<block>             : tell_that<&Builder::end_statement> {};
template <> struct action<call_statement>    : tell_that<&Builder::end_statement> {};
template <> struct action<property>          : tell_that<&Builder::end_statement> {};
// clang-format on

}  // namespace lancer::grammar
