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
    const auto part = [&](int shift) {
        return srgb_decode(static_cast<double>((rgb >> shift) & 0xFF) / 255.0);
    };
    return {part(16), part(8), part(0)};
}

/// After a condition that is no bool nothing is known: the whole expression is broken.
void Evaluator::give_up(Run& run) {
    stack_.resize(run.bottom);
    drop_labels(run.bottom);
    run.at = run.end;
}

Value Evaluator::evaluate(const ast::File& file, const ast::Expression& expression) {
    if (expression.end - expression.begin == 1) {
        const ast::Step& only = file.steps[expression.begin];
        if (only.op == Op::number) return Value(only.number());
    }
    Run run;
    run.file = &file;
    run.at = expression.begin;
    run.end = expression.end;
    run.bottom = stack_.size();
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
            stack_.emplace_back(std::string(text(step.low())));
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
            const auto first = stack_.end() - static_cast<std::ptrdiff_t>(count);
            const bool wrong =
                std::any_of(first, stack_.end(), [](const Value& v) { return v.is_broken(); });
            Value list(std::vector<Value>(std::make_move_iterator(first),
                                          std::make_move_iterator(stack_.end())));
            stack_.erase(first, stack_.end());
            if (list.depth() > meter_.limits().nesting) {
                report_.error(Message::list_depth, file.span(step), meter_.limits().nesting);
                list = Value();
            }
            stack_.push_back(wrong ? Value() : std::move(list));
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
        case Op::jump:
            run.at = step.low();
            break;
        default: {  // an operator with two sides
            const Value right = pop();
            const Value left = pop();
            stack_.push_back(
                apply_binary(step.op, left, right, {report_, meter_, file.span(step)}));
            break;
        }
    }
}

}  // namespace lancer
