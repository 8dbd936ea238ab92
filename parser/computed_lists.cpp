// Lists that are computed: [for i in 0..n if i != 3: f(i)]. The elements gather on the stack, the
// iterations that are open stand beside it.
#include <algorithm>

#include "parser/evaluator.h"

namespace lancer {

using ast::Op;

void Evaluator::take_list_step(Run& run, const ast::Step& step) {
    const SourceSpan place = run.file->span(step);
    switch (step.op) {
        case Op::gather:
            meter_.elements(step.payload, place);
            gathers_.push_back(stack_.size() - static_cast<std::size_t>(step.payload));
            break;
        case Op::bound:
            if (!is_bound(stack_.back(), place)) stack_.back() = Value();
            break;
        case Op::each_number: {
            const Value to = pop();
            const Value from = pop();
            Iteration range;
            range.is_range = true;
            if (from.is_broken() || to.is_broken()) {
                stack_.emplace_back();  // and so is the list
            } else if (to.number() > from.number()) {
                range.start = from.number();
                range.count = static_cast<std::uint64_t>(to.number() - from.number());
            }
            begin_iteration(run, step, std::move(range));
            break;
        }
        case Op::each_element: {
            Iteration over;
            over.list = pop();
            if (over.list.is_list()) {
                over.count = over.list.size();
            } else {
                if (!over.list.is_broken())
                    report_.error(Message::loop_type, place, describe(over.list));
                stack_.emplace_back();
            }
            begin_iteration(run, step, std::move(over));
            break;
        }
        case Op::only_if:
            only_if(run, step);
            break;
        case Op::keep:
            meter_.elements(1, place);
            check_held(place);
            break;
        case Op::again:
            go_on(run, step);
            break;
        default: {  // gathered
            const std::size_t first = gathers_.back();
            gathers_.pop_back();
            push_list(first, place);
            break;
        }
    }
}

/// Opens the scope of its variable, with the first value; without one it goes on behind.
void Evaluator::begin_iteration(Run& run, const ast::Step& step, Iteration iteration) {
    if (iteration.count == 0) {
        run.at = step.high();
        return;
    }
    meter_.statement(run.file->span(step));
    Binding binding;
    binding.name = step.low();
    binding.place = run.file->span(step);
    binding.value = iteration.is_range ? Value(iteration.start) : iteration.list.at(0);
    scopes_.open();
    scopes_.bind(std::move(binding));
    iterations_.push_back(std::move(iteration));
}

void Evaluator::go_on(Run& run, const ast::Step& step) {
    Iteration& iteration = iterations_.back();
    if (++iteration.position == iteration.count) {
        end_iterations(iterations_.size() - 1);
        return;
    }
    meter_.statement(run.file->span(step));
    scopes_.rebind(iteration.is_range
                       ? Value(iteration.start + static_cast<double>(iteration.position))
                       : iteration.list.at(iteration.position));
    run.at = step.low();
}

void Evaluator::only_if(Run& run, const ast::Step& step) {
    const Value condition = pop();
    if (condition.is(Value::Kind::boolean)) {
        if (!condition.boolean()) run.at = step.low();
        return;
    }
    if (!condition.is_broken())
        report_.error(Message::condition_type, run.file->span(step), "'if'", describe(condition));
    stack_.emplace_back();  // the list is broken
    run.at = step.low();
}

/// Ends the innermost iterations until no more than `most` are open.
void Evaluator::end_iterations(std::size_t most) {
    for (; iterations_.size() > most; iterations_.pop_back()) scopes_.close();
}

/// Makes a list of the values from `first` on.
void Evaluator::push_list(std::size_t first, const SourceSpan& place) {
    constexpr std::size_t many = 1 << 16;
    const auto elements = std::span(stack_).subspan(first);
    const bool wrong =
        std::any_of(elements.begin(), elements.end(), [](const Value& v) { return v.is_broken(); });
    const bool long_one = elements.size() > many;
    Value list = wrong ? Value() : Value::list_of(elements);
    stack_.resize(first);
    if (long_one) stack_.shrink_to_fit();
    if (list.depth() > meter_.limits().nesting) {
        report_.error(Message::list_depth, place, meter_.limits().nesting);
        list = Value();
    }
    stack_.push_back(std::move(list));
    check_held(place);
}

/// Values that are held at one time are bounded, too: what elements hold may be large.
void Evaluator::check_held(const SourceSpan& place) {
    meter_.held(Value::held_bytes() + stack_.size() * sizeof(Value), place);
}

}  // namespace lancer
