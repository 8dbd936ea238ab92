#include "parser/evaluation/expressions.h"

#include <cmath>

#include "model/srgb.h"
#include "parser/operators.h"

namespace lancer {

using ast::Op;

/// The linear colour of 0xrrggbb.
static Value color_value(std::uint32_t rgb) {
    const Vec3d light = srgb_color(rgb);
    return {light.x, light.y, light.z};
}

/// The common case: two numbers with a finite result, which replaces the left one.
static bool operate_on_numbers(Op op, Value& left, const Value& right) {
    if (!left.is_number() || !right.is_number()) return false;
    double result = 0;
    switch (op) {
        case Op::add:
            result = left.number() + right.number();
            break;
        case Op::subtract:
            result = left.number() - right.number();
            break;
        case Op::multiply:
            result = left.number() * right.number();
            break;
        case Op::divide:
            if (right.number() == 0) return false;
            result = left.number() / right.number();
            break;
        default:
            return false;
    }
    if (!std::isfinite(result)) return false;
    left = Value(result);
    return true;
}

Value Expressions::evaluate(const ast::File& file, const ast::Expression& expression) {
    if (expression.end - expression.begin == 1) {
        const ast::Step& only = file.steps[expression.begin];
        if (only.op == Op::number) return Value(only.number());
    }
    Run run = lists_.begin_run(file, expression);
    for (;;) {
        while (run.at < run.end) take(run, run.file->steps[run.at++]);
        Value result = stack_.size() > run.bottom ? stack_.pop() : Value();
        if (run.function == nullptr) return result;
        calls_.end(run, std::move(result));
    }
}

void Expressions::take(Run& run, const ast::Step& step) {
    const ast::File& file = *run.file;
    switch (step.op) {
        case Op::number:
            stack_.push(Value(step.number()));
            break;
        case Op::text:
            stack_.push(literal(step.low()));
            break;
        case Op::yes:
            stack_.push(Value(true));
            break;
        case Op::no:
            stack_.push(Value(false));
            break;
        case Op::color:
            stack_.push(color_value(step.low()));
            break;
        case Op::name:
            stack_.push(names_.value_of(file, step));
            break;
        case Op::call:
            calls_.call(run, step);
            break;
        case Op::named:
            stack_.name_top(step);
            break;
        case Op::list: {
            const auto count = static_cast<std::size_t>(step.payload);
            context_.meter.elements(count, file.span(step));
            lists_.make_list(stack_.size() - count, file.span(step));
            break;
        }
        case Op::and_then:
        case Op::or_else:
        case Op::and_end:
        case Op::or_end:
        case Op::choose:
            take_condition(run, step);
            break;
        case Op::block:
            stack_.push(in_place_.make(file, static_cast<std::uint32_t>(step.payload)));
            break;
        case Op::skip:
        case Op::jump:
            run.at = step.low();
            break;
        case Op::gather:
        case Op::bound:
        case Op::each_number:
        case Op::each_element:
        case Op::only_if:
        case Op::keep:
        case Op::again:
        case Op::gathered:
            lists_.take(run, step);
            break;
        case Op::index:
        case Op::member:
        case Op::negate:
        case Op::invert:
            take_operator(file, step);
            break;
        default:  // a binary operator
            if (operate_on_numbers(step.op, stack_.below_top(), stack_.top()))
                stack_.drop();
            else
                take_operator(file, step);
            break;
    }
}

void Expressions::take_operator(const ast::File& file, const ast::Step& step) {
    const auto site = [&] { return Site{context_.report, context_.meter, file.span(step)}; };
    switch (step.op) {
        case Op::index: {
            const Value index = stack_.pop();
            const Value list = stack_.pop();
            stack_.push(element_at(list, index, site()));
            break;
        }
        case Op::member: {
            const Value vector = stack_.pop();
            stack_.push(component_of(vector, step.low(), site()));
            break;
        }
        case Op::negate:
        case Op::invert: {
            const Value operand = stack_.pop();
            stack_.push(apply_unary(step.op, operand, site()));
            break;
        }
        default: {  // a binary operator on other values than two numbers
            const Value right = stack_.pop();
            const Value left = stack_.pop();
            stack_.push(apply_binary(step.op, left, right, site()));
            break;
        }
    }
}

/// The steps of &&, || and ?: that test the value on top of the stack.
void Expressions::take_condition(Run& run, const ast::Step& step) {
    const Value& top = stack_.top();
    if (!top.is(Value::Kind::boolean)) {
        if (!top.is_broken()) {
            const bool is_and = step.op == Op::and_then || step.op == Op::and_end;
            const char* what = step.op == Op::choose ? "'?'" : is_and ? "'&&'" : "'||'";
            context_.report.error(Message::condition_type, run.file->span(step), what,
                                  kind_name(top));
        }
        give_up(run);
        return;
    }
    const bool value = top.boolean();
    if (step.op == Op::and_end || step.op == Op::or_end) return;
    if (step.op == Op::choose) {
        stack_.drop();
        if (!value) run.at = step.low();
    } else if (value == (step.op == Op::or_else)) {
        run.at = step.low();
    } else {
        stack_.drop();
    }
}

/// After a condition that is not a bool, the whole expression is broken.
void Expressions::give_up(Run& run) {
    stack_.cut(run.bottom);
    lists_.give_up(run);
    run.at = run.end;
}

/// A string literal. All copies of its value share the text.
const Value& Expressions::literal(Symbol symbol) {
    if (literals_.size() <= symbol) literals_.resize(symbol + 1);
    if (literals_[symbol].is_broken())
        literals_[symbol] = Value(std::string(context_.text(symbol)));
    return literals_[symbol];
}

}  // namespace lancer
