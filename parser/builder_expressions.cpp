// The builder's part for expressions: a flat chain of operands and operators becomes postfix steps
// by precedence (Dijkstra's shunting-yard algorithm), so long chains need no recursion.
#include <algorithm>
#include <charconv>
#include <string>

#include "parser/builder.h"
#include "parser/scan.h"

namespace lancer::grammar {
namespace {

using ast::Op;

struct Binding {
    std::string_view text;
    Op op;
    std::uint8_t precedence;
};

constexpr std::uint8_t unary_precedence = 7;
constexpr std::uint8_t power_precedence = 8;

/// The weakest binding first, as in the manual.
constexpr Binding bindings[] = {
    {"||", Op::or_end, 1},     {"&&", Op::and_end, 2},
    {"==", Op::equal, 3},      {"!=", Op::not_equal, 3},
    {"<=", Op::less_equal, 4}, {">=", Op::greater_equal, 4},
    {"<", Op::less, 4},        {">", Op::greater, 4},
    {"+", Op::add, 5},         {"-", Op::subtract, 5},
    {"*", Op::multiply, 6},    {"/", Op::divide, 6},
    {"%", Op::modulo, 6},      {"^", Op::power, power_precedence},
};

constexpr std::uint64_t pair(std::uint64_t low, std::uint64_t high) {
    return low | high << 32;
}

}  // namespace

void Builder::emit(Op op, const char* begin, const char* end, std::uint64_t payload) {
    make_room(file_.steps, 1);
    file_.steps.push_back(
        {payload, offset_of(begin), ast::capped(static_cast<std::size_t>(end - begin)), op});
    last_end_ = std::max(last_end_, end);
}

void Builder::number(const char* begin, const char* end) {
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || stop != end) throw SyntaxError{Message::number_out_of_range, begin};
    emit(Op::number, begin, end, std::bit_cast<std::uint64_t>(value));
}

void Builder::string(const char* begin, const char* end) {
    const std::string_view inside(begin + 1, static_cast<std::size_t>(end - begin) - 2);
    Symbol symbol = no_symbol;
    if (inside.find('\\') == std::string_view::npos) {
        symbol = symbols_.intern(inside);
    } else {
        std::string plain;
        for (std::size_t i = 0; i < inside.size(); ++i) {
            char c = inside[i];
            if (c == '\\') {
                c = inside[++i];
                if (c == 'n') c = '\n';
                if (c == 't') c = '\t';
            }
            plain += c;
        }
        symbol = symbols_.intern(plain);
    }
    emit(Op::text, begin, end, symbol);
}

void Builder::color(const char* begin, const char* end) {
    std::uint32_t value = 0;
    std::from_chars(begin + 1, end, value, 16);
    emit(Op::color, begin, end, value);
}

void Builder::boolean(const char* begin, const char* end, bool value) {
    emit(value ? Op::yes : Op::no, begin, end, 0);
}

void Builder::callee(const char* begin, const char* end) {
    const std::string_view name(begin, static_cast<std::size_t>(end - begin));
    within_.callees.push_back(
        {symbols_.intern(name), offset_of(begin), ast::capped(name.size()), Op::name});
    last_end_ = end;
}

void Builder::plain_name() {
    make_room(file_.steps, 1);
    file_.steps.push_back(within_.callees.back());
    within_.callees.pop_back();
}

void Builder::open_bracket(const char* at) {
    within_.brackets.push_back(at);
}

void Builder::open_list(const char* at) {
    within_.brackets.push_back(at);
    within_.counts.emplace_back();
}

void Builder::label(const char* begin, const char* end) {
    const std::string_view name(begin, static_cast<std::size_t>(end - begin));
    within_.labels.push_back(
        {symbols_.intern(name), offset_of(begin), static_cast<std::uint32_t>(name.size()), {}});
}

void Builder::end_labelled() {
    const ast::Argument label = within_.labels.back();
    within_.labels.pop_back();
    const char* at = text_.data() + label.offset;
    emit(Op::named, at, at + label.length, label.name);
}

void Builder::end_list(const char* end) {
    const Listed& listed = within_.counts.back();
    emit(listed.gathers ? Op::gathered : Op::list, within_.brackets.back(), end, listed.count);
    within_.brackets.pop_back();
    within_.counts.pop_back();
}

void Builder::end_call(const char* end) {
    ast::Step call = within_.callees.back();
    call.op = Op::call;
    call.payload = pair(call.payload, within_.counts.back().count);
    file_.steps.push_back(call);
    last_end_ = end;
    within_.callees.pop_back();
    within_.counts.pop_back();
    within_.brackets.pop_back();
}

void Builder::end_index(const char* end) {
    emit(Op::index, within_.brackets.back(), end, 0);
    within_.brackets.pop_back();
}

void Builder::end_parentheses(const char* end) {
    within_.brackets.pop_back();
    last_end_ = end;
}

void Builder::member(const char* begin, const char* end) {
    emit(Op::member, begin, end, static_cast<std::uint64_t>(end[-1] - 'x'));
}

void Builder::prefix(const char* at) {
    deeper(at);
    within_.operators.push_back(
        {*at == '-' ? Op::negate : Op::invert, unary_precedence, at, at + 1, 0});
}

void Builder::infix(const char* begin, const char* end) {
    const std::string_view text(begin, static_cast<std::size_t>(end - begin));
    const Binding& binding = *std::find_if(std::begin(bindings), std::end(bindings),
                                           [&](const Binding& b) { return b.text == text; });
    const bool right_associative = binding.op == Op::power;
    while (within_.operators.size() > within_.bases.back() &&
           (within_.operators.back().precedence > binding.precedence ||
            (within_.operators.back().precedence == binding.precedence && !right_associative)))
        pop_operator();
    std::uint32_t branch = 0;
    if (binding.op == Op::and_end || binding.op == Op::or_end) {
        branch = static_cast<std::uint32_t>(file_.steps.size());
        emit(binding.op == Op::and_end ? Op::and_then : Op::or_else, begin, end, 0);
    }
    if (binding.op == Op::power) deeper(begin);
    within_.operators.push_back({binding.op, binding.precedence, begin, end, branch});
}

void Builder::pop_operator() {
    const OpenExpressions::Operator pending = within_.operators.back();
    within_.operators.pop_back();
    if (pending.precedence >= unary_precedence) --nesting_;
    ast::Step& last = file_.steps.back();
    if (pending.op == Op::negate && last.op == Op::number) {  // a literal with its sign
        last.payload = std::bit_cast<std::uint64_t>(-last.number());
        const auto end = last.offset + last.length;
        last.offset = offset_of(pending.begin);
        last.length = ast::capped(end - last.offset);
        return;
    }
    emit(pending.op, pending.begin, pending.end, 0);
    if (pending.op == Op::and_end || pending.op == Op::or_end)
        file_.steps[pending.branch].payload = file_.steps.size();
}

void Builder::end_chain() {
    while (within_.operators.size() > within_.bases.back()) pop_operator();
    within_.bases.pop_back();
}

void Builder::question(const char* at) {
    within_.branches.push_back(static_cast<std::uint32_t>(file_.steps.size()));
    emit(Op::choose, at, at + 1, 0);
}

void Builder::colon(const char* at) {
    const std::uint32_t choose = within_.branches.back();
    within_.branches.back() = static_cast<std::uint32_t>(file_.steps.size());
    emit(Op::jump, at, at + 1, 0);
    file_.steps[choose].payload = file_.steps.size();
}

void Builder::end_alternatives() {
    file_.steps[within_.branches.back()].payload = file_.steps.size();
    within_.branches.pop_back();
}

bool Builder::is_block_in_place(const char* at) {
    const std::string_view word = word_at(at);
    const Symbol symbol = word.empty() ? no_symbol : symbols_.intern(word);
    if (symbol != vocabulary_.material && symbol != vocabulary_.texture) return false;
    if (scan::next_token(text_, offset_of(at) + word.size()).kind != scan::Token::Kind::open_brace)
        return false;
    if (open_.building.empty()) return true;
    const ast::Statement& around = open_.building.back();
    const bool has_body =
        around.kind == ast::Statement::Kind::loop || around.kind == ast::Statement::Kind::choice;
    return !has_body ||
           (!within_.brackets.empty() && offset_of(within_.brackets.back()) > around.offset);
}

/// The block's statements have steps of their own; the expression around the block skips them.
void Builder::begin_in_place(const char* begin, const char* end) {
    within_.skips.push_back({static_cast<std::uint32_t>(file_.steps.size()), file_.arguments.size(),
                             file_.parts.size(), within_.labels.size()});
    emit(Op::skip, begin, end, 0);
    begin_statement(ast::Statement::Kind::block, begin, end);
}

void Builder::end_in_place() {
    const Skip skip = within_.skips.back();
    within_.skips.pop_back();
    ast::Step block = file_.steps[skip.step];
    file_.steps[skip.step].payload = file_.steps.size();
    // An expression or call around the block may be reading arguments. Those since the block began
    // belong to calls, which a block of properties cannot hold, so they are dropped.
    for (std::size_t i = skip.parts; i < file_.parts.size(); ++i) file_.parts[i].arguments = {};
    file_.arguments.resize(skip.arguments);
    block.op = Op::block;
    block.payload = file_.statements.size();
    file_.steps.push_back(block);
    file_.statements.push_back(closed(open_.building.back()));
    open_.building.pop_back();
    last_end_ = last_brace_;
}

void Builder::begin_value(const char* at) {
    const auto begin = static_cast<std::uint32_t>(file_.steps.size());
    within_.values.push_back({begin, begin, offset_of(at), 0});
    last_end_ = at;
}

ast::Expression Builder::take_value() {
    ast::Expression value = within_.values.back();
    within_.values.pop_back();
    value.end = static_cast<std::uint32_t>(file_.steps.size());
    value.length = offset_of(last_end_) - value.offset;
    return value;
}

void Builder::end_value() {
    using Kind = ast::Statement::Kind;
    last_value_ = take_value();
    if (open_.building.empty()) return;
    ast::Statement& statement = open_.building.back();
    switch (statement.kind) {
        case Kind::property:
        case Kind::let:
        case Kind::param:
        case Kind::include:
        case Kind::choice:
        case Kind::loop:
        case Kind::assertion:
            if (statement.value.empty()) statement.value = last_value_;
            break;
        default:
            break;  // part(), argument(), default_value() or function_value() takes it
    }
}

}  // namespace lancer::grammar
