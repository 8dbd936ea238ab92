// Calls in expressions: functions of the language and of the script.
#include <algorithm>
#include <cmath>

#include "parser/evaluator.h"
#include "parser/habits.h"
#include "parser/suggest.h"

namespace lancer {

using ast::Op;

/// `sin(90)`: an angle that can only be meant in degrees, as a number written in place.
void Evaluator::warn_of_degrees(const ast::File& file, const ast::Step& call,
                                std::string_view function) {
    const ast::Step& argument = (&call)[-1];
    if (argument.op != Op::number) return;
    if (function != "sin" && function != "cos" && function != "tan") return;
    constexpr double least = 10;
    const double angle = argument.number();
    if (std::abs(angle) < least || angle != std::floor(angle)) return;
    const std::string degrees = to_text(angle);
    Diagnostic* warning =
        report_.warning(Message::angle_of_degrees, file.span(call), function, degrees);
    if (warning != nullptr)
        warning->hint = "of degrees: " + std::string(function) + "(radians(" + degrees + "))";
}

/// A function of the language, of the arguments on top of the stack.
Value Evaluator::apply_function(const Function& function, const ast::File& file,
                                const ast::Step& step) {
    const std::size_t count = step.high();
    const SourceSpan place = file.span(step);
    const auto arguments = std::span<const Value>(stack_).last(count);
    bool good = std::none_of(arguments.begin(), arguments.end(),
                             [](const Value& v) { return v.is_broken(); });
    for (const Label& label : labels_of_call(count)) {
        report_.error(Message::named_to_function, file.span(*label.step));
        good = false;
    }
    if (count < function.least || count > function.most) {
        report_.error(Message::function_count, place, function.name,
                      arguments_text(function.least, function.most), count);
        good = false;
    }
    if (!good) return {};
    warn_of_degrees(file, step, function.name);
    Value result = function.apply(function.name, arguments, {report_, meter_, place});
    if (is_finite_value(result)) return result;
    report_.error(Message::not_finite, place);
    return {};
}

/// The names that were given to arguments of a call of so many, in their order.
std::span<const Evaluator::Label> Evaluator::labels_of_call(std::size_t count) const {
    auto first = labels_.size();
    while (first > 0 && labels_[first - 1].argument >= stack_.size() - count) --first;
    return std::span(labels_).subspan(first);
}

/// Puts the arguments of a call in the order of the parameters, one place on the stack for each: a
/// broken value where none is given. False after an error, one in an argument included.
bool Evaluator::arrange_arguments(const Run& run, const ast::Step& call, const Binding& callee) {
    const std::size_t count = call.high();
    const SourceSpan place = run.file->span(call);
    const ast::Statement& definition = *callee.definition;
    const auto parameters = std::span(callee.file->arguments)
                                .subspan(definition.arguments.begin, definition.arguments.size());
    const auto labels = labels_of_call(count);
    const std::size_t first = stack_.size() - count;
    const bool broken = std::any_of(stack_.begin() + static_cast<std::ptrdiff_t>(first),
                                    stack_.end(), [](const Value& v) { return v.is_broken(); });
    const std::size_t unnamed = labels.empty() ? count : labels.front().argument - first;
    if (unnamed + labels.size() < count) {
        report_.error(Message::positional_after_named, place);
        return false;
    }
    if (unnamed > parameters.size()) {
        report_.error(Message::too_many_arguments, place, text(definition.name),
                      arguments_text(parameters.size()), count);
        return false;
    }
    if (!labels.empty() && !arrange_named(run, callee, labels, unnamed)) return false;
    stack_.resize(first + parameters.size());
    for (std::size_t i = unnamed; i < parameters.size(); ++i) {
        if (!stack_[first + i].is_broken() || !parameters[i].value.empty() || broken) continue;
        report_.error(Message::missing_argument, place, text(definition.name),
                      text(parameters[i].name));
        return false;
    }
    return !broken;
}

/// The same for the arguments that have names, which stand behind the others.
bool Evaluator::arrange_named(const Run& run, const Binding& callee, std::span<const Label> labels,
                              std::size_t unnamed) {
    const ast::Range& range = callee.definition->arguments;
    const auto parameters = std::span(callee.file->arguments).subspan(range.begin, range.size());
    const std::size_t first = labels.front().argument - unnamed;
    std::vector<Value> arranged(parameters.size());
    for (std::size_t i = 0; i < unnamed; ++i) arranged[i] = std::move(stack_[first + i]);
    std::vector<bool> given(parameters.size());
    std::fill_n(given.begin(), unnamed, true);
    bool good = true;
    for (const Label& label : labels) {
        const Symbol name = label.step->low();
        const auto at = std::find_if(parameters.begin(), parameters.end(),
                                     [&](const auto& p) { return p.name == name; });
        const auto index = static_cast<std::size_t>(at - parameters.begin());
        const SourceSpan place = run.file->span(*label.step);
        if (at == parameters.end()) {
            report_unknown_argument(place, *callee.file, *callee.definition, name);
            good = false;
        } else if (given[index]) {
            report_.error(Message::argument_twice, place, text(name));
            good = false;
        } else {
            arranged[index] = std::move(stack_[label.argument]);
            given[index] = true;
        }
    }
    stack_.resize(first);
    std::move(arranged.begin(), arranged.end(), std::back_inserter(stack_));
    return good;
}

void Evaluator::report_unknown_argument(const SourceSpan& place, const ast::File& home,
                                        const ast::Statement& definition, Symbol name) {
    Diagnostic* error =
        report_.error(Message::unknown_argument, place, text(definition.name), text(name));
    if (error == nullptr) return;
    Suggestion suggestion(text(name));
    for (std::uint32_t i = definition.arguments.begin; i < definition.arguments.end; ++i)
        suggestion.consider(text(home.arguments[i].name));
    error->hint = suggestion.hint();
}

/// Goes on in a function of the script; what called it waits on a stack of its own.
void Evaluator::begin_call(Run& run, const ast::Step& call, const Binding& callee) {
    const std::size_t count = call.high();
    const std::size_t first = stack_.size() - count;
    const bool arranged = arrange_arguments(run, call, callee);
    drop_labels(first);
    if (!arranged) {
        stack_.resize(first);
        stack_.emplace_back();
        return;
    }
    const SourceSpan place = run.file->span(call);
    enter_call(place, text(callee.name));
    meter_.statement(place);
    Run body = begin_run(*callee.file, callee.definition->value);
    body.function = callee.definition;
    body.caller = scopes_.enter(callee);
    mark_executed(*body.file,
                  static_cast<std::uint32_t>(body.function - body.file->statements.data()));
    scopes_.open();
    runs_.push_back(run);
    run = body;
    bind_parameters(run);
}

/// Binds the parameters from `run.parameter` on, up to one whose default is to be evaluated before;
/// after the last one the run goes on with the function's expression.
void Evaluator::bind_parameters(Run& run) {
    const ast::Range& range = run.function->arguments;
    const ast::Expression* next = &run.function->value;
    for (; run.parameter < range.size(); ++run.parameter) {
        Value& given = stack_[run.bottom - range.size() + run.parameter];
        const ast::Argument& parameter = run.file->arguments[range.begin + run.parameter];
        if (given.is_broken()) {
            next = &parameter.value;
            break;
        }
        bind_parameter(*run.file, parameter, std::move(given));
    }
    run.at = next->begin;
    run.end = next->end;
}

void Evaluator::bind_parameter(const ast::File& home, const ast::Argument& parameter, Value value) {
    Binding binding;
    binding.name = parameter.name;
    binding.place = home.span(parameter);
    binding.value = std::move(value);
    scopes_.bind(std::move(binding));
}

/// What a run of a function has evaluated is a default, or what its call stands for.
void Evaluator::end_run(Run& run, Value result) {
    const ast::Range& parameters = run.function->arguments;
    if (run.parameter < parameters.size()) {
        bind_parameter(*run.file, run.file->arguments[parameters.begin + run.parameter],
                       std::move(result));
        ++run.parameter;
        bind_parameters(run);
        return;
    }
    scopes_.close();
    scopes_.leave(run.caller);
    report_.calls.pop_back();
    stack_.resize(run.bottom - parameters.size());
    run = runs_.back();
    runs_.pop_back();
    stack_.push_back(std::move(result));
}

void Evaluator::drop_labels(std::size_t first) {
    while (!labels_.empty() && labels_.back().argument >= first) labels_.pop_back();
}

void Evaluator::call(Run& run, const ast::Step& step) {
    const Symbol name = step.low();
    const std::size_t count = step.high();
    const SourceSpan place = run.file->span(step);
    const Binding* binding = scopes_.find_callable(name);
    if (binding != nullptr && binding->kind == Binding::Kind::function) {
        begin_call(run, step, *binding);
        return;
    }
    Value result;
    if (binding != nullptr) {
        Diagnostic* error = binding->kind == Binding::Kind::definition
                                ? report_.error(Message::template_in_expression, place, text(name))
                                : nullptr;
        if (error != nullptr) error->hint = habits::callables;
    } else if (name < functions_.size() && functions_[name] != nullptr) {
        result = apply_function(*functions_[name], *run.file, step);
    } else if (scopes_.find(name) != nullptr) {
        report_undefined(Message::not_a_template, place, name, true);
    } else {
        report_undefined(Message::function_not_defined, place, name, true);
    }
    drop_labels(stack_.size() - count);
    stack_.resize(stack_.size() - count);
    stack_.push_back(std::move(result));
}

}  // namespace lancer
