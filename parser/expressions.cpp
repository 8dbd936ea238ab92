// Evaluates expressions: postfix steps on a stack of values. A call of a function of the script
// goes on in the same loop (function_calls.cpp).
#include <algorithm>
#include <cmath>

#include "model/srgb.h"
#include "parser/evaluator.h"

namespace lancer {

using ast::Op;

Value Evaluator::pop() {
    Value top = std::move(stack_.back());
    stack_.pop_back();
    return top;
}

/// A colour from 0xrrggbb.
static Value color_value(std::uint32_t rgb) {
    const Vec3d light = srgb_color(rgb);
    return {light.x, light.y, light.z};
}

/// After a condition that is no bool nothing is known: the whole expression is broken.
void Evaluator::give_up(Run& run) {
    stack_.resize(run.bottom);
    drop_labels(run.bottom);
    end_iterations(run.iterations);
    gathers_.resize(run.gathers);
    run.at = run.end;
}

/// What most operators meet: two numbers, with a result that is finite. The left one becomes it.
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

Evaluator::Run Evaluator::begin_run(const ast::File& file,
                                    const ast::Expression& expression) const {
    Run run;
    run.file = &file;
    run.at = expression.begin;
    run.end = expression.end;
    run.bottom = stack_.size();
    run.iterations = iterations_.size();
    run.gathers = gathers_.size();
    return run;
}

/// A string of the text, which all that have it share.
const Value& Evaluator::literal(Symbol symbol) {
    if (literals_.size() <= symbol) literals_.resize(symbol + 1);
    if (literals_[symbol].is_broken()) literals_[symbol] = Value(std::string(text(symbol)));
    return literals_[symbol];
}

Value Evaluator::evaluate(const ast::File& file, const ast::Expression& expression) {
    if (expression.end - expression.begin == 1) {
        const ast::Step& only = file.steps[expression.begin];
        if (only.op == Op::number) return Value(only.number());
    }
    Run run = begin_run(file, expression);
    for (;;) {
        while (run.at < run.end) take(run, run.file->steps[run.at++]);
        Value result = stack_.size() > run.bottom ? pop() : Value();
        if (run.function == nullptr) return result;
        end_run(run, std::move(result));
    }
}

void Evaluator::take(Run& run, const ast::Step& step) {
    const ast::File& file = *run.file;
    switch (step.op) {
        case Op::number:
            stack_.emplace_back(step.number());
            break;
        case Op::text:
            stack_.push_back(literal(step.low()));
            break;
        case Op::yes:
            stack_.emplace_back(true);
            break;
        case Op::no:
            stack_.emplace_back(false);
            break;
        case Op::color:
            stack_.push_back(color_value(step.low()));
            break;
        case Op::name:
            push_name(file, step);
            break;
        case Op::call:
            call(run, step);
            break;
        case Op::named:
            labels_.push_back({stack_.size() - 1, &step});
            break;
        case Op::list: {
            const auto count = static_cast<std::size_t>(step.payload);
            meter_.elements(count, file.span(step));
            push_list(stack_.size() - count, file.span(step));
            break;
        }
        case Op::index: {
            const Value index = pop();
            const Value list = pop();
            stack_.push_back(element_at(list, index, {report_, meter_, file.span(step)}));
            break;
        }
        case Op::member: {
            const Value vector = pop();
            stack_.push_back(component_of(vector, step.low(), {report_, meter_, file.span(step)}));
            break;
        }
        case Op::negate:
        case Op::invert: {
            const Value operand = pop();
            stack_.push_back(apply_unary(step.op, operand, {report_, meter_, file.span(step)}));
            break;
        }
        case Op::and_then:
        case Op::or_else:
        case Op::and_end:
        case Op::or_end:
        case Op::choose: {
            const Value& top = stack_.back();
            if (!top.is(Value::Kind::boolean)) {
                if (!top.is_broken()) {
                    const bool is_and = step.op == Op::and_then || step.op == Op::and_end;
                    const char* what = step.op == Op::choose ? "'?'" : is_and ? "'&&'" : "'||'";
                    report_.error(Message::condition_type, file.span(step), what, kind_name(top));
                }
                give_up(run);
                return;
            }
            const bool value = top.boolean();
            if (step.op == Op::and_end || step.op == Op::or_end) break;
            if (step.op == Op::choose) {
                stack_.pop_back();
                if (!value) run.at = step.low();
            } else if (value == (step.op == Op::or_else)) {
                run.at = step.low();
            } else {
                stack_.pop_back();
            }
            break;
        }
        case Op::block:
            stack_.push_back(block_in_place(file, static_cast<std::uint32_t>(step.payload)));
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
            take_list_step(run, step);
            break;
        default: {  // an operator with two sides
            if (operate_on_numbers(step.op, stack_[stack_.size() - 2], stack_.back())) {
                stack_.pop_back();
                break;
            }
            const Value right = pop();
            const Value left = pop();
            stack_.push_back(
                apply_binary(step.op, left, right, {report_, meter_, file.span(step)}));
            break;
        }
    }
}

}  // namespace lancer
