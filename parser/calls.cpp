// Templates and included files.
#include <algorithm>
#include <filesystem>

#include "parser/evaluator.h"
#include "parser/syntax.h"

namespace lancer {
namespace {

/// Without `.` and `..`, unless that would lead elsewhere: `..` after a link to a folder is that
/// folder's parent.
std::string tidied(const std::filesystem::path& path) {
    const std::filesystem::path tidy = path.lexically_normal();
    if (tidy.native() == path.native()) return tidy.string();  // as nearly always: no question
    std::error_code ignored;
    const bool elsewhere =
        std::filesystem::exists(path, ignored) && !std::filesystem::equivalent(path, tidy, ignored);
    return (elsewhere ? path : tidy).string();
}

}  // namespace

void Evaluator::define_callable(const ast::File& file, const ast::Statement& statement) {
    const SourceSpan place = file.name_span(statement);
    const Vocabulary& vocabulary = program_.vocabulary;
    Binding binding;
    const bool is_template = statement.kind == ast::Statement::Kind::def;
    binding.kind = is_template ? Binding::Kind::definition : Binding::Kind::function;
    binding.name = statement.name;
    binding.place = place;
    binding.file = &file;
    binding.definition = &statement;
    if (is_template && vocabulary.in_statements().knows(statement.name)) {
        report_.error(Message::template_takes_word, place, text(statement.name));
        return;
    }
    if (is_template && vocabulary.is_block(statement.name))
        report_.warning(Message::template_and_block, place, text(statement.name),
                        text(statement.name));
    if (statement.name < functions_.size() && functions_[statement.name] != nullptr)
        report_.warning(Message::hides_function, place, text(statement.name));
    const auto parameters =
        std::span(file.arguments).subspan(statement.arguments.begin, statement.arguments.size());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (parameters[i].name != parameters[j].name) continue;
            Diagnostic* error = report_.error(Message::already_defined, file.span(parameters[i]),
                                              text(parameters[i].name));
            if (error != nullptr)
                error->notes.insert(error->notes.begin(),
                                    Report::note(Message::first_here, file.span(parameters[j])));
            binding.kind = Binding::Kind::broken_definition;
            break;
        }
    }
    declare(std::move(binding));
}

void Evaluator::enter_call(const SourceSpan& place, std::string_view name) {
    if (report_.calls.size() >= meter_.limits().calls) {
        report_.error(Message::call_limit, place, meter_.limits().calls);
        throw StopReading{};
    }
    report_.calls.push_back({place, name});
}

bool Evaluator::match_arguments(const ast::File& file, const ast::Statement& call,
                                const ast::File& home, const ast::Statement& definition,
                                std::vector<Given>& given) {
    const auto parameters =
        std::span(home.arguments).subspan(definition.arguments.begin, definition.arguments.size());
    const auto arguments =
        std::span(file.arguments).subspan(call.arguments.begin, call.arguments.size());
    const std::string_view callee = text(call.word);
    given.resize(parameters.size());
    bool good = true;
    bool named = false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const ast::Argument& argument = arguments[i];
        Value value = evaluate(file, argument.value);
        std::size_t index = i;
        if (argument.name != no_symbol) {
            named = true;
            const auto at = std::find_if(parameters.begin(), parameters.end(),
                                         [&](const auto& p) { return p.name == argument.name; });
            if (at == parameters.end()) {
                good = false;
                report_unknown_argument(file.span(argument), home, definition, argument.name);
                continue;
            }
            index = static_cast<std::size_t>(at - parameters.begin());
        } else if (named) {
            good = false;
            report_.error(Message::positional_after_named, file.span(argument.value));
            continue;
        } else if (index >= parameters.size()) {
            good = false;
            report_.error(Message::too_many_arguments, file.span(argument.value), callee,
                          arguments_text(parameters.size()), arguments.size());
            continue;
        }
        if (given[index].is_given) {
            good = false;
            report_.error(Message::argument_twice, file.span(argument),
                          text(parameters[index].name));
            continue;
        }
        given[index] = {std::move(value), true};
    }
    return good;
}

/// Every parameter has a value or a default.
bool Evaluator::are_complete(const ast::File& home, const ast::Statement& definition,
                             const SourceSpan& call, const std::vector<Given>& given) {
    bool complete = true;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const ast::Argument& parameter = home.arguments[definition.arguments.begin + i];
        if (given[i].is_given || !parameter.value.empty()) continue;
        complete = false;
        report_.error(Message::missing_argument, call, text(definition.name), text(parameter.name));
    }
    return complete;
}

/// In the scope of the call: binds what is given, evaluates the rest, which may use earlier ones.
void Evaluator::bind_given(const ast::File& home, const ast::Statement& definition,
                           std::vector<Given>& given) {
    for (std::size_t i = 0; i < given.size(); ++i) {
        const ast::Argument& parameter = home.arguments[definition.arguments.begin + i];
        bind_parameter(
            home, parameter,
            given[i].is_given ? std::move(given[i].value) : evaluate(home, parameter.value));
    }
}

void Evaluator::execute_call(const ast::File& file, const ast::Statement& statement) {
    const Symbol name = statement.word;
    const SourceSpan place = file.span(statement);
    const Binding* callee = scopes_.find_callable(name);
    if (callee == nullptr) {
        if (name < functions_.size() && functions_[name] != nullptr) {
            report_.error(Message::function_as_statement, place, text(name));
        } else if (program_.vocabulary.is_block(name)) {
            report_.error(Message::block_as_call, place, text(name));
        } else if (scopes_.find(name) != nullptr) {
            report_undefined(Message::not_a_template, place, name, true);
        } else {
            report_undefined(Message::function_not_defined, place, name, true);
        }
        return;
    }
    if (callee->kind == Binding::Kind::broken_definition) return;
    if (callee->kind == Binding::Kind::function) {
        report_.error(Message::function_as_statement, place, text(name));
        return;
    }
    const ast::File& home = *callee->file;
    const ast::Statement& definition = *callee->definition;
    std::vector<Given> given;
    if (!match_arguments(file, statement, home, definition, given)) return;
    if (!are_complete(home, definition, place, given)) return;
    enter_call(place, text(name));
    // Calls in the arguments may have moved the bindings.
    const Scopes::Caller caller = scopes_.enter(*scopes_.find_callable(name));
    scopes_.open();
    bind_given(home, definition, given);
    Frame& frame = push(Frame::Kind::call, home, definition.body);
    frame.caller = caller;
    frame.outer_group = group_;
    group_ = none;
}

std::string Evaluator::identity(const std::string& path) {
    std::error_code error;
    const auto absolute = std::filesystem::absolute(path, error);
    const auto followed = std::filesystem::weakly_canonical(absolute, error);
    return (error ? absolute.lexically_normal() : followed).string();
}

std::string Evaluator::resolve_path(const ast::File& file, std::string_view path) const {
    const std::filesystem::path given(path);
    const std::string& script = sources_.name(file.source);
    if (given.is_absolute() || script == "-") return tidied(given);
    return tidied(std::filesystem::path(script).parent_path() / given);
}

ast::File* Evaluator::load_script(const std::string& path, const SourceSpan& place,
                                  const SourceSpan& statement) {
    LoadedScript& loaded = program_.scripts[identity(path)];
    if (loaded.file == nullptr && loaded.problem.empty()) {
        try {
            std::string source = loader_.text(path, meter_.source_left());
            loaded.bytes = source.size();
            meter_.source(loaded.bytes, place);
            const std::uint32_t index = add_source(sources_, path, std::move(source));
            loaded.file = std::make_unique<ast::File>();
            report_.calls.push_back({statement, ""});  // syntax errors come through it
            *loaded.file = read_syntax(index, sources_, program_.symbols, program_.vocabulary,
                                       meter_.limits().nesting, report_);
            report_.calls.pop_back();
        } catch (const FileError& error) {
            loaded.problem = error.what();
        }
    } else {
        meter_.source(loaded.bytes, place);
    }
    if (loaded.file == nullptr) {
        incomplete_ = true;
        report_unreadable(path, place, loaded.problem);
    }
    return loaded.file.get();
}

void Evaluator::execute_include(const ast::File& file, const ast::Statement& statement) {
    const SourceSpan place = file.span(statement.value);
    const Value value = evaluate(file, statement.value);
    if (value.is_broken()) return;
    if (!value.is(Value::Kind::text)) {
        report_.error(Message::include_type, place, describe(value));
        return;
    }
    const std::string path = resolve_path(file, value.text());
    const std::string key = identity(path);
    if (const auto at = std::find(including_.begin(), including_.end(), key);
        at != including_.end()) {
        std::string chain;
        for (auto link = at; link != including_.end(); ++link)
            chain += std::filesystem::path(*link).filename().string() + " -> ";
        chain += std::filesystem::path(key).filename().string();
        report_.error(Message::include_cycle, place, chain);
        return;
    }
    if (!included_.insert(key).second) return;
    const ast::File* included = load_script(path, place, file.span(statement));
    if (included == nullptr) return;
    enter_call(file.span(statement), "");
    including_.push_back(key);
    push(Frame::Kind::include, *included, included->body);
}

}  // namespace lancer
