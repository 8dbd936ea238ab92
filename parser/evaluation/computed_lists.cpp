#include "parser/evaluation/computed_lists.h"

#include <algorithm>

namespace lancer {

using ast::Op;

Run ComputedLists::begin_run(const ast::File& file, const ast::Expression& expression) const {
    Run run;
    run.file = &file;
    run.at = expression.begin;
    run.end = expression.end;
    run.bottom = stack_.size();
    run.iterations = iterations_.size();
    run.gathers = gathers_.size();
    return run;
}

void ComputedLists::give_up(const Run& run) {
    end_iterations(run.iterations);
    gathers_.resize(run.gathers);
}

void ComputedLists::take(Run& run, const ast::Step& step) {
    const SourceSpan place = run.file->span(step);
    switch (step.op) {
        case Op::gather:
            context_.meter.elements(step.payload, place);
            gathers_.push_back(stack_.size() - static_cast<std::size_t>(step.payload));
            break;
        case Op::bound:
            if (!is_range_bound(stack_.top(), place, context_.report)) stack_.top() = Value();
            break;
        case Op::each_number:
            begin_range(run, step);
            break;
        case Op::each_element:
            begin_elements(run, step);
            break;
        case Op::only_if:
            only_if(run, step);
            break;
        case Op::keep:
            context_.meter.elements(1, place);
            check_held(place);
            break;
        case Op::again:
            go_on(run, step);
            break;
        default: {  // the list is complete
            const std::size_t first = gathers_.back();
            gathers_.pop_back();
            make_list(first, place);
            break;
        }
    }
}

void ComputedLists::begin_range(Run& run, const ast::Step& step) {
    const Value to = stack_.pop();
    const Value from = stack_.pop();
    if (from.is_broken() || to.is_broken()) {
        stack_.push_broken();  // the list becomes broken, too
        begin(run, step, {});
    } else {
        begin(run, step, Iteration::range(from.number(), to.number()));
    }
}

void ComputedLists::begin_elements(Run& run, const ast::Step& step) {
    Value list = stack_.pop();
    if (list.is_list()) {
        begin(run, step, Iteration::over(std::move(list)));
        return;
    }
    if (!list.is_broken())
        context_.report.error(Message::loop_type, run.file->span(step), describe(list));
    stack_.push_broken();
    begin(run, step, {});
}

/// Opens a scope for the variable with the first value. Without a value, the run goes on after the
/// iteration.
void ComputedLists::begin(Run& run, const ast::Step& step, Iteration iteration) {
    if (iteration.at_end()) {
        run.at = step.high();
        return;
    }
    const SourceSpan place = run.file->span(step);
    context_.meter.statement(place);
    Binding binding;
    binding.name = step.low();
    binding.place = place;
    binding.value = iteration.value();
    scopes_.open();
    scopes_.bind(std::move(binding));
    iterations_.push_back(std::move(iteration));
}

void ComputedLists::go_on(Run& run, const ast::Step& step) {
    Iteration& iteration = iterations_.back();
    ++iteration.position;
    if (iteration.at_end()) {
        end_iterations(iterations_.size() - 1);
        return;
    }
    context_.meter.statement(run.file->span(step));
    scopes_.rebind(iteration.value());
    run.at = step.low();
}

void ComputedLists::only_if(Run& run, const ast::Step& step) {
    const Value condition = stack_.pop();
    if (condition.is(Value::Kind::boolean)) {
        if (!condition.boolean()) run.at = step.low();
        return;
    }
    if (!condition.is_broken())
        context_.report.error(Message::condition_type, run.file->span(step), "'if'",
                              describe(condition));
    stack_.push_broken();  // the list is broken
    run.at = step.low();
}

/// Ends the innermost iterations until no more than `most` are open.
void ComputedLists::end_iterations(std::size_t most) {
    for (; iterations_.size() > most; iterations_.pop_back()) scopes_.close();
}

void ComputedLists::make_list(std::size_t first, const SourceSpan& place) {
    constexpr std::size_t many = 1 << 16;
    const auto elements = stack_.from(first);
    const bool wrong =
        std::any_of(elements.begin(), elements.end(), [](const Value& v) { return v.is_broken(); });
    const bool long_one = elements.size() > many;
    Value list = wrong ? Value() : Value::list_of(elements);
    stack_.cut(first);
    if (long_one) stack_.shrink();
    const std::uint64_t deepest = context_.meter.limits().nesting;
    if (list.depth() > deepest) {
        context_.report.error(Message::list_depth, place, deepest);
        list = Value();
    }
    stack_.push(std::move(list));
    check_held(place);
}

/// Bounds the memory of the values that are held at one time: a single element may be large.
void ComputedLists::check_held(const SourceSpan& place) {
    context_.meter.held(Value::held_bytes() + stack_.size() * sizeof(Value), place);
}

}  // namespace lancer
