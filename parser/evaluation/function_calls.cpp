#include "parser/evaluation/function_calls.h"

#include <algorithm>

#include "parser/evaluation/builtin_calls.h"
#include "parser/habits.h"

namespace lancer {

void FunctionCalls::call(Run& run, const ast::Step& step) {
    const Symbol name = step.low();
    const Binding* binding = names_.scopes().find_callable(name);
    if (binding != nullptr && binding->kind == Binding::Kind::function) {
        enter(run, step, *binding);
        return;
    }
    Value result;
    const Function* function = binding == nullptr ? names_.function(name) : nullptr;
    if (function != nullptr) {
        result = call_builtin(*function, *run.file, step, stack_, context_);
    } else {
        report_no_function(name, run.file->span(step), binding);
    }
    stack_.cut(stack_.size() - step.high());
    stack_.push(std::move(result));
}

void FunctionCalls::report_no_function(Symbol name, const SourceSpan& place,
                                       const Binding* binding) {
    if (binding == nullptr) {
        const bool has_value = names_.scopes().find(name) != nullptr;
        names_.report_undefined(has_value ? Message::not_a_template : Message::function_not_defined,
                                place, name, true);
        return;
    }
    if (binding->kind != Binding::Kind::definition) return;  // reported at its definition
    Diagnostic* error =
        context_.report.error(Message::template_in_expression, place, context_.text(name));
    if (error != nullptr) error->hint = habits::callables;
}

/// Continues in a function of the script; the caller's run waits.
void FunctionCalls::enter(Run& run, const ast::Step& call, const Binding& callee) {
    const std::size_t first = stack_.size() - call.high();
    if (!arrange(run, call, {*callee.file, *callee.definition})) {
        stack_.cut(first);
        stack_.push_broken();
        return;
    }
    const SourceSpan place = run.file->span(call);
    context_.enter_call(place, context_.text(callee.name));
    context_.meter.statement(place);
    Run body = lists_.begin_run(*callee.file, callee.definition->value);
    body.function = callee.definition;
    body.caller = names_.scopes().enter(callee);
    executed_.mark(*body.file,
                   static_cast<std::uint32_t>(body.function - body.file->statements.data()));
    names_.scopes().open();
    waiting_.push_back(run);
    run = body;
    bind_parameters(run);
}

/// Puts the arguments of a call in the order of the parameters, one stack place each. A parameter
/// without an argument gets a broken value. False after an error, also after one within an
/// argument.
bool FunctionCalls::arrange(const Run& run, const ast::Step& call, const Parameters& parameters) {
    const std::size_t count = call.high();
    const std::size_t first = stack_.size() - count;
    const SourceSpan place = run.file->span(call);
    Report& report = context_.report;
    const auto labels = stack_.labels_from(first);
    const auto arguments = stack_.from(first);
    const bool broken = std::any_of(arguments.begin(), arguments.end(),
                                    [](const Value& v) { return v.is_broken(); });
    const std::size_t unnamed = labels.empty() ? count : labels.front().argument - first;
    if (unnamed + labels.size() < count) {
        report.error(Message::positional_after_named, place);
        return false;
    }
    if (unnamed > parameters.size()) {
        report.error(Message::too_many_arguments, place, context_.text(parameters.name()),
                     arguments_text(parameters.size()), count);
        return false;
    }
    if (!labels.empty() && !arrange_named(run, first, unnamed, parameters)) return false;
    stack_.fill_up(first + parameters.size());
    for (std::size_t i = unnamed; i < parameters.size(); ++i) {
        if (!stack_[first + i].is_broken() || !parameters[i].value.empty() || broken) continue;
        report.error(Message::missing_argument, place, context_.text(parameters.name()),
                     context_.text(parameters[i].name));
        return false;
    }
    return !broken;
}

/// The same for named arguments, which stand after the others.
bool FunctionCalls::arrange_named(const Run& run, std::size_t first, std::size_t unnamed,
                                  const Parameters& parameters) {
    std::vector<Given> given(parameters.size());
    for (std::size_t i = 0; i < unnamed; ++i) given[i] = {std::move(stack_[first + i]), true};
    bool good = true;
    for (const ValueStack::Label& label : stack_.labels_from(first))
        good &= parameters.give(label.step->low(), std::move(stack_[label.argument]), given,
                                run.file->span(*label.step), context_);
    stack_.cut(first);
    for (Given& argument : given) stack_.push(std::move(argument.value));
    return good;
}

/// Binds the parameters from `run.parameter` on, up to one whose default must be evaluated first.
/// After the last one, the run goes on with the function's expression.
void FunctionCalls::bind_parameters(Run& run) {
    const ast::Range& range = run.file->parts_of(*run.function).arguments;
    const ast::Expression* next = &run.function->value;
    for (; run.parameter < range.size(); ++run.parameter) {
        Value& given = stack_[run.bottom - range.size() + run.parameter];
        const ast::Argument& parameter = run.file->arguments[range.begin + run.parameter];
        if (given.is_broken()) {
            next = &parameter.value;
            break;
        }
        names_.scopes().bind(parameter_binding(*run.file, parameter, std::move(given)));
    }
    run.at = next->begin;
    run.end = next->end;
}

void FunctionCalls::end(Run& run, Value result) {
    const ast::Range& parameters = run.file->parts_of(*run.function).arguments;
    if (run.parameter < parameters.size()) {
        names_.scopes().bind(parameter_binding(
            *run.file, run.file->arguments[parameters.begin + run.parameter], std::move(result)));
        ++run.parameter;
        bind_parameters(run);
        return;
    }
    names_.scopes().close();
    names_.scopes().leave(run.caller);
    context_.leave_call();
    stack_.cut(run.bottom - parameters.size());
    run = waiting_.back();
    waiting_.pop_back();
    stack_.push(std::move(result));
}

}  // namespace lancer
