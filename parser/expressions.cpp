// Evaluates expressions: postfix steps on a stack of values.
#include <algorithm>
#include <cmath>

#include "model/srgb.h"
#include "parser/evaluator.h"
#include "parser/habits.h"
#include "parser/suggest.h"

namespace lancer {

using ast::Op;

Value Evaluator::pop() {
    Value top = std::move(stack_.back());
    stack_.pop_back();
    return top;
}

bool Evaluator::has_value(Symbol name) const {
    return scopes_.find(name) != nullptr || constants_.contains(name);
}

/// A colour from 0xrrggbb.
static Value color_value(std::uint32_t rgb) {
    const auto part = [&](int shift) {
        return srgb_decode(static_cast<double>((rgb >> shift) & 0xFF) / 255.0);
    };
    return {part(16), part(8), part(0)};
}

/// Where a name that means nothing here is defined in the same file: later, or in other braces.
SourceSpan Evaluator::place_of_definition(const SourceSpan& use, Symbol name) const {
    const ast::File* file = program_.main.source == use.file ? &program_.main : nullptr;
    for (const auto& [path, script] : program_.scripts)
        if (script.file != nullptr && script.file->source == use.file) file = script.file.get();
    if (file == nullptr) return {};
    using Kind = ast::Statement::Kind;
    const Vocabulary& vocabulary = program_.vocabulary;
    for (const ast::Statement& s : file->statements) {
        const bool names_value = s.kind == Kind::block &&
                                 (s.word == vocabulary.material || s.word == vocabulary.texture);
        if (s.name == name &&
            (names_value || s.kind == Kind::let || s.kind == Kind::param || s.kind == Kind::def))
            return file->name_span(s);
    }
    return {};
}

void Evaluator::report_undefined(Message message, const SourceSpan& place, Symbol name,
                                 bool functions) {
    Diagnostic* error = report_.error(message, place, text(name));
    if (error == nullptr) return;
    if (const SourceSpan later = place_of_definition(place, name);
        later.file != SourceSpan::nowhere) {
        const bool is_later = later.offset > place.offset;
        error->notes.insert(
            error->notes.begin(),
            Report::note(is_later ? Message::defined_later : Message::defined_elsewhere, later));
        if (is_later) error->hint = "a name is defined before its use";
        return;
    }
    if (const std::string_view color = habits::color_called(text(name)); !color.empty()) {
        error->hint = "colours have no names: write " + std::string(color);
        return;
    }
    if (const std::string_view instead = habits::instead_of(text(name)); !instead.empty()) {
        error->hint = instead;
        return;
    }
    Suggestion suggestion(text(name));
    scopes_.for_each_visible([&](const Binding& binding) {
        if ((binding.kind == Binding::Kind::value) != functions)
            suggestion.consider(text(binding.name));
    });
    if (functions) {
        for (const Function& f : all_functions()) suggestion.consider(f.name);
    } else {
        for (const auto& [symbol, value] : constants_) suggestion.consider(text(symbol));
    }
    error->hint = suggestion.hint();
}

void Evaluator::push_name(const ast::File& file, const ast::Step& step) {
    const Symbol name = step.low();
    if (const Binding* binding = scopes_.find(name)) {
        if (binding->kind == Binding::Kind::definition)
            report_.error(Message::template_as_value, file.span(step), text(name));
        stack_.push_back(binding->value);
        return;
    }
    if (const auto constant = constants_.find(name); constant != constants_.end()) {
        stack_.emplace_back(constant->second);
        return;
    }
    if (name < functions_.size() && functions_[name] != nullptr) {
        report_.error(Message::function_as_value, file.span(step), text(name));
    } else {
        report_undefined(Message::name_not_defined, file.span(step), name, false);
    }
    stack_.emplace_back();
}

/// "1 argument", "2 or 3 arguments", "2 or more arguments".
static std::string count_text(std::size_t least, std::size_t most) {
    std::string text = std::to_string(least);
    if (most > least + 1) {
        text += " or more";
    } else if (most > least) {
        text += " or " + std::to_string(most);
    }
    return text + (text == "1" ? " argument" : " arguments");
}

/// `sin(90)`: an angle that can only be meant in degrees, as a number written in place.
void Evaluator::warn_of_degrees(const ast::File& file, const ast::Step& call,
                                std::string_view function) {
    if (function != "sin" && function != "cos" && function != "tan") return;
    constexpr double least = 10;
    const ast::Step& argument = (&call)[-1];
    if (argument.op != Op::number) return;
    const double angle = argument.number();
    if (std::abs(angle) < least || angle != std::floor(angle)) return;
    const std::string degrees = to_text(angle);
    Diagnostic* warning =
        report_.warning(Message::angle_of_degrees, file.span(call), function, degrees);
    if (warning != nullptr)
        warning->hint = "of degrees: " + std::string(function) + "(radians(" + degrees + "))";
}

void Evaluator::push_call(const ast::File& file, const ast::Step& step) {
    const Symbol name = step.low();
    const std::size_t count = step.high();
    const SourceSpan place = file.span(step);
    const auto arguments = std::span<const Value>(stack_).last(count);
    Value result;
    const Binding* binding = scopes_.find_template(name);
    if (binding != nullptr) {
        if (binding->kind == Binding::Kind::definition)
            report_.error(Message::template_in_expression, place, text(name));
    } else if (name >= functions_.size() || functions_[name] == nullptr) {
        if (scopes_.find(name) != nullptr) {
            report_undefined(Message::not_a_template, place, name, true);
        } else {
            report_undefined(Message::function_not_defined, place, name, true);
        }
    } else {
        const Function& function = *functions_[name];
        if (count < function.least || count > function.most) {
            report_.error(Message::function_count, place, function.name,
                          count_text(function.least, function.most), count);
        } else if (std::none_of(arguments.begin(), arguments.end(),
                                [](const Value& v) { return v.is_broken(); })) {
            warn_of_degrees(file, step, function.name);
            result = function.apply(function.name, arguments, {report_, meter_, place});
            if (!is_finite_value(result)) {
                report_.error(Message::not_finite, place);
                result = Value();
            }
        }
    }
    stack_.resize(stack_.size() - count);
    stack_.push_back(std::move(result));
}

Value Evaluator::evaluate(const ast::File& file, const ast::Expression& expression) {
    if (expression.end - expression.begin == 1) {
        const ast::Step& only = file.steps[expression.begin];
        if (only.op == Op::number) return Value(only.number());
    }
    const std::size_t bottom = stack_.size();
    std::uint32_t at = expression.begin;
    // After a condition that is no bool nothing is known: the whole expression is broken.
    const auto broken = [&] {
        stack_.resize(bottom);
        return Value();
    };
    while (at < expression.end) {
        const ast::Step& step = file.steps[at++];
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
                push_call(file, step);
                break;
            case Op::named:
                report_.error(Message::named_to_function, file.span(step));
                stack_.back() = Value();
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
                stack_.push_back(
                    component_of(vector, step.low(), {report_, meter_, file.span(step)}));
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
                        report_.error(Message::condition_type, file.span(step), what,
                                      kind_name(top));
                    }
                    return broken();
                }
                const bool value = top.boolean();
                if (step.op == Op::and_end || step.op == Op::or_end) break;
                if (step.op == Op::choose) {
                    stack_.pop_back();
                    if (!value) at = step.low();
                } else if (value == (step.op == Op::or_else)) {
                    at = step.low();
                } else {
                    stack_.pop_back();
                }
                break;
            }
            case Op::jump:
                at = step.low();
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
    return stack_.size() > bottom ? pop() : Value();
}

}  // namespace lancer
