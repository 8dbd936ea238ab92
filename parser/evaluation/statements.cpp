#include "parser/evaluation/statements.h"

namespace lancer {

using Kind = ast::Statement::Kind;

void Statements::run(const ast::File& file) {
    names_.scopes().open();
    // Most statements of a long file are objects.
    context_.builder.scene.objects.reserve(file.body.size());
    push(Frame::Kind::include, file, file.body).file_level = true;
    while (!frames_.empty()) step();
}

void Statements::step() {
    Frame& frame = frames_.back();
    if (frame.next == frame.end) {
        end_frame();
        return;
    }
    const ast::File& file = *frame.file;
    const ast::Statement& statement = file.statements[frame.next];
    // a func is marked when it is called
    if (statement.kind != Kind::func) executed_.mark(file, frame.next);
    ++frame.next;
    context_.meter.statement(file.span(statement));
    execute(file, statement);
}

void Statements::execute(const ast::File& file, const ast::Statement& statement) {
    switch (statement.kind) {
        case Kind::property:
            blocks_.read_property(file, statement);
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
            templates_.define(file, statement);
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
        case Kind::broken:
            execute_broken(file, statement);
            break;
    }
}

Statements::Frame& Statements::push(Frame::Kind kind, const ast::File& file,
                                    const ast::Range& body) {
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

void Statements::end_frame() {
    Frame& frame = frames_.back();
    switch (frame.kind) {
        case Frame::Kind::body:
            names_.scopes().close();
            break;
        case Frame::Kind::loop:
            names_.scopes().close();
            if (next_iteration(frame)) return;
            break;
        case Frame::Kind::call:
            templates_.leave(frame.caller);
            groups_.show(frame.outer_group);
            break;
        case Frame::Kind::group:
            names_.scopes().close();
            groups_.close(frame.outer_group);
            break;
        case Frame::Kind::include:
            if (frames_.size() > 1)
                includes_.leave();
            else
                names_.scopes().close();
            break;
    }
    frames_.pop_back();
}

/// The binding for the name that a statement declares, still without a value.
static Binding binding_of(const ast::File& file, const ast::Statement& statement) {
    Binding binding;
    binding.name = file.name_of(statement);
    binding.place = file.name_span(statement);
    return binding;
}

void Statements::execute_let(const ast::File& file, const ast::Statement& statement) {
    Binding binding = binding_of(file, statement);
    binding.value = context_.expressions.evaluate(file, statement.value);
    names_.declare(std::move(binding));
}

void Statements::execute_param(const ast::File& file, const ast::Statement& statement) {
    if (!frames_.back().file_level)
        context_.report.error(Message::param_not_at_top, file.span(statement));
    Binding binding = binding_of(file, statement);
    binding.value = context_.expressions.evaluate(file, statement.value);
    if (const Value* given = params_.take(binding.name)) binding.value = *given;
    names_.declare(std::move(binding));
}

/// Binds the name of a declaration with a syntax error to a broken value, so that its uses report
/// nothing more.
void Statements::execute_broken(const ast::File& file, const ast::Statement& statement) {
    Binding binding = binding_of(file, statement);
    const std::string_view word = context_.text(statement.word);
    const bool callable = word == "def" || word == "func";
    if (callable) binding.kind = Binding::Kind::broken_definition;
    Scopes& scopes = names_.scopes();
    if (scopes.find_here(binding.name) == nullptr) scopes.bind(std::move(binding));
}

void Statements::execute_block(const ast::File& file, const ast::Statement& statement) {
    const BlockWord* group = blocks_.read_block(file, statement);
    if (group == nullptr) return;
    const Groups::Open outer = groups_.open(file, statement, *group);
    push(Frame::Kind::group, file, file.parts_of(statement).body).outer_group = outer;
    names_.scopes().open();
}

void Statements::execute_call(const ast::File& file, const ast::Statement& statement) {
    const auto entered = templates_.enter(file, statement);
    if (!entered) return;
    Frame& frame =
        push(Frame::Kind::call, entered->file, entered->file.parts_of(entered->definition).body);
    frame.caller = entered->caller;
    frame.outer_group = groups_.hide();
}

void Statements::execute_include(const ast::File& file, const ast::Statement& statement) {
    const Value name = context_.expressions.evaluate(file, statement.value);
    const ast::File* included = includes_.enter(file, statement, name);
    if (included != nullptr) push(Frame::Kind::include, *included, included->body);
}

void Statements::execute_choice(const ast::File& file, const ast::Statement& statement) {
    bool result = false;
    if (!condition(file, statement.value, "'if'", result)) return;
    const ast::Parts& parts = file.parts_of(statement);
    if (!result && !parts.otherwise) return;
    names_.scopes().open();
    push(Frame::Kind::body, file, result ? parts.body : *parts.otherwise);
}

void Statements::execute_loop(const ast::File& file, const ast::Statement& statement) {
    Value from = context_.expressions.evaluate(file, statement.value);
    Iteration iteration;
    const ast::Parts& parts = file.parts_of(statement);
    if (!parts.arguments.empty()) {
        const ast::Expression& end = file.arguments[parts.arguments.begin].value;
        const Value to = context_.expressions.evaluate(file, end);
        const bool good = is_range_bound(from, file.span(statement.value), context_.report);
        if (!is_range_bound(to, file.span(end), context_.report) || !good) return;
        iteration = Iteration::range(from.number(), to.number());
    } else if (from.is_broken()) {
        return;
    } else if (!from.is_list()) {
        context_.report.error(Message::loop_type, file.span(statement.value), describe(from));
        return;
    } else {
        iteration = Iteration::over(std::move(from));
    }
    Frame& frame = push(Frame::Kind::loop, file, parts.body);
    frame.loop = &statement;
    frame.iteration = std::move(iteration);
    if (!next_iteration(frame)) frames_.pop_back();
}

bool Statements::next_iteration(Frame& frame) {
    if (frame.iteration.at_end()) return false;
    const ast::File& file = *frame.file;
    context_.meter.statement(file.span(*frame.loop));
    Binding binding = binding_of(file, *frame.loop);
    binding.value = frame.iteration.value();
    ++frame.iteration.position;
    frame.next = frame.first;
    names_.scopes().open();
    names_.scopes().bind(std::move(binding));
    return true;
}

/// Evaluates a condition. False after an error: there is no result.
bool Statements::condition(const ast::File& file, const ast::Expression& expression,
                           std::string_view what, bool& result) {
    const Value value = context_.expressions.evaluate(file, expression);
    if (value.is_broken()) return false;
    if (!value.is(Value::Kind::boolean)) {
        context_.report.error(Message::condition_type, file.span(expression), what,
                              describe(value));
        return false;
    }
    result = value.boolean();
    return true;
}

void Statements::execute_assertion(const ast::File& file, const ast::Statement& statement) {
    bool holds = false;
    if (!condition(file, statement.value, "'assert'", holds) || holds) return;
    std::string message(context_.sources.text(file.span(statement.value)));
    if (const ast::Range& said = file.parts_of(statement).arguments; !said.empty()) {
        const ast::Expression& given = file.arguments[said.begin].value;
        const Value value = context_.expressions.evaluate(file, given);
        if (value.is_broken()) return;
        if (!value.is(Value::Kind::text)) {
            context_.report.error(Message::assertion_message, file.span(given), describe(value));
            return;
        }
        message = value.text();
    }
    context_.report.error(Message::assertion_failed, file.span(statement.value), message);
}

void Statements::execute_print(const ast::File& file, const ast::Statement& statement) {
    std::string line;
    const ast::Range& printed = file.parts_of(statement).arguments;
    for (std::uint32_t i = printed.begin; i < printed.end; ++i) {
        const Value value = context_.expressions.evaluate(file, file.arguments[i].value);
        if (i > printed.begin) line += ' ';
        line += to_text(value, context_.meter.text_left());
    }
    context_.meter.text(line.size() + sizeof(std::string), file.span(statement));
    printed_.push_back(std::move(line));
}

}  // namespace lancer
