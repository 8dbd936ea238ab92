// Runs statements, one frame at a time.
#include <cmath>

#include "parser/evaluator.h"

namespace lancer {

using Kind = ast::Statement::Kind;

Evaluator::Frame& Evaluator::push(Frame::Kind kind, const ast::File& file, const ast::Range& body) {
    const bool file_level =
        kind == Frame::Kind::include && !frames_.empty() && frames_.back().file_level;
    Frame& frame = frames_.emplace_back();
    frame.kind = kind;
    frame.file_level = file_level;
    frame.file = &file;
    frame.first = frame.next = body.begin;
    frame.end = body.end;
    return frame;
}

void Evaluator::run() {
    scopes_.open();
    // Most of what a long file says are objects.
    builder_.scene.objects.reserve(program_.main.body.size());
    push(Frame::Kind::include, program_.main, program_.main.body).file_level = true;
    while (!frames_.empty()) step();
}

void Evaluator::step() {
    Frame& frame = frames_.back();
    if (frame.next == frame.end) {
        end_frame();
        return;
    }
    const ast::File& file = *frame.file;
    const ast::Statement& statement = file.statements[frame.next];
    if (statement.kind != Kind::func) mark_executed(file, frame.next);  // its calls do
    ++frame.next;
    meter_.statement(file.span(statement));
    execute(file, statement);
}

void Evaluator::execute(const ast::File& file, const ast::Statement& statement) {
    switch (statement.kind) {
        case Kind::property:
            execute_property(file, statement);
            break;
        case Kind::block:
            execute_block(file, statement);
            break;
        case Kind::call:
            execute_call(file, statement);
            break;
        case Kind::let:
            execute_let(file, statement);
            break;
        case Kind::param:
            execute_param(file, statement);
            break;
        case Kind::def:
        case Kind::func:
            define_callable(file, statement);
            break;
        case Kind::loop:
            execute_loop(file, statement);
            break;
        case Kind::choice:
            execute_choice(file, statement);
            break;
        case Kind::include:
            execute_include(file, statement);
            break;
        case Kind::assertion:
            execute_assertion(file, statement);
            break;
        case Kind::print:
            execute_print(file, statement);
            break;
        case Kind::broken: {
            Binding binding;
            const bool callable = text(statement.word) == "def" || text(statement.word) == "func";
            binding.kind = callable ? Binding::Kind::broken_definition : Binding::Kind::value;
            binding.name = statement.name;
            binding.place = file.name_span(statement);
            if (scopes_.find_here(binding.name) == nullptr) scopes_.bind(std::move(binding));
            break;
        }
    }
}

void Evaluator::end_frame() {
    Frame& frame = frames_.back();
    switch (frame.kind) {
        case Frame::Kind::body:
            scopes_.close();
            break;
        case Frame::Kind::loop:
            scopes_.close();
            if (next_iteration(frame)) return;
            break;
        case Frame::Kind::call:
            scopes_.close();
            scopes_.leave(frame.caller);
            group_ = frame.outer_group;
            report_.calls.pop_back();
            break;
        case Frame::Kind::group: {
            scopes_.close();
            builder_.close_group(groups_.back().attributes);
            groups_.pop_back();
            group_ = frame.outer_group;
            break;
        }
        case Frame::Kind::include:
            if (frames_.size() > 1) {
                report_.calls.pop_back();
                including_.pop_back();
            } else {
                scopes_.close();
            }
            break;
    }
    frames_.pop_back();
}

bool Evaluator::declare(Binding binding) {
    if (const Binding* first = scopes_.find_here(binding.name)) {
        Diagnostic* error =
            report_.error(Message::already_defined, binding.place, text(binding.name));
        if (error != nullptr)
            error->notes.insert(error->notes.begin(),
                                Report::note(Message::first_here, first->place));
        return false;
    }
    scopes_.bind(std::move(binding));
    return true;
}

void Evaluator::execute_let(const ast::File& file, const ast::Statement& statement) {
    Binding binding;
    binding.name = statement.name;
    binding.place = file.name_span(statement);
    binding.value = evaluate(file, statement.value);
    declare(std::move(binding));
}

void Evaluator::execute_param(const ast::File& file, const ast::Statement& statement) {
    if (!frames_.back().file_level) report_.error(Message::param_not_at_top, file.span(statement));
    Binding binding;
    binding.name = statement.name;
    binding.place = file.name_span(statement);
    params_.push_back(statement.name);
    binding.value = evaluate(file, statement.value);
    if (const auto given = defined_.find(statement.name); given != defined_.end()) {
        binding.value = given->second.first;
        given->second.second = true;
    }
    declare(std::move(binding));
}

bool Evaluator::condition(const ast::File& file, const ast::Expression& expression,
                          std::string_view what, bool& result) {
    const Value value = evaluate(file, expression);
    if (value.is_broken()) return false;
    if (!value.is(Value::Kind::boolean)) {
        report_.error(Message::condition_type, file.span(expression), what, describe(value));
        return false;
    }
    result = value.boolean();
    return true;
}

void Evaluator::execute_choice(const ast::File& file, const ast::Statement& statement) {
    bool result = false;
    if (!condition(file, statement.value, "'if'", result)) return;
    if (!result && !statement.has_otherwise) return;
    const bool file_level = false;
    scopes_.open();
    push(Frame::Kind::body, file, result ? statement.body : statement.otherwise).file_level =
        file_level;
}

/// Whether a range may begin or end there; if not, that is reported.
bool Evaluator::is_bound(const Value& value, const SourceSpan& place) {
    constexpr double most = 9007199254740992.0;  // beyond 2^53 not every number is there
    if (value.is_broken()) return false;
    if (value.is_number() && value.number() == std::floor(value.number()) &&
        std::abs(value.number()) <= most)
        return true;
    report_.error(Message::range_bound, place, describe(value));
    return false;
}

void Evaluator::execute_loop(const ast::File& file, const ast::Statement& statement) {
    Value from = evaluate(file, statement.value);
    Value to;
    const bool is_range = !statement.arguments.empty();
    if (is_range) {
        const ast::Expression& end = file.arguments[statement.arguments.begin].value;
        to = evaluate(file, end);
        const bool good = is_bound(from, file.span(statement.value));
        if (!is_bound(to, file.span(end)) || !good) return;
    } else if (from.is_broken()) {
        return;
    } else if (!from.is_list()) {
        report_.error(Message::loop_type, file.span(statement.value), describe(from));
        return;
    }
    Frame& frame = push(Frame::Kind::loop, file, statement.body);
    frame.statement = &statement;
    frame.is_range = is_range;
    if (is_range) {
        frame.start = from.number();
        frame.count = to.number() > from.number()
                          ? static_cast<std::uint64_t>(to.number() - from.number())
                          : 0;
    } else {
        frame.count = from.size();
        frame.list = std::move(from);
    }
    if (!next_iteration(frame)) frames_.pop_back();
}

bool Evaluator::next_iteration(Frame& frame) {
    if (frame.position == frame.count) return false;
    const ast::File& file = *frame.file;
    meter_.statement(file.span(*frame.statement));
    Binding binding;
    binding.name = frame.statement->name;
    binding.place = file.name_span(*frame.statement);
    binding.value = frame.is_range ? Value(frame.start + static_cast<double>(frame.position))
                                   : frame.list.at(frame.position);
    ++frame.position;
    frame.next = frame.first;
    scopes_.open();
    scopes_.bind(std::move(binding));
    return true;
}

void Evaluator::execute_assertion(const ast::File& file, const ast::Statement& statement) {
    bool holds = false;
    if (!condition(file, statement.value, "'assert'", holds) || holds) return;
    std::string message(sources_.text(file.span(statement.value)));
    if (!statement.arguments.empty()) {
        const ast::Expression& given = file.arguments[statement.arguments.begin].value;
        const Value value = evaluate(file, given);
        if (value.is_broken()) return;
        if (!value.is(Value::Kind::text)) {
            report_.error(Message::assertion_message, file.span(given), describe(value));
            return;
        }
        message = value.text();
    }
    report_.error(Message::assertion_failed, file.span(statement.value), message);
}

void Evaluator::execute_print(const ast::File& file, const ast::Statement& statement) {
    std::string line;
    for (std::uint32_t i = statement.arguments.begin; i < statement.arguments.end; ++i) {
        const Value value = evaluate(file, file.arguments[i].value);
        if (i > statement.arguments.begin) line += ' ';
        line += to_text(value, meter_.text_left());
    }
    meter_.text(line.size() + sizeof(std::string), file.span(statement));
    printed_.push_back(std::move(line));
}

}  // namespace lancer
