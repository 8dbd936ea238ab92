#include "parser/evaluation/template_calls.h"

#include "parser/functions.h"

namespace lancer {

void TemplateCalls::define(const ast::File& file, const ast::Statement& statement) {
    const SourceSpan place = file.name_span(statement);
    const Vocabulary& vocabulary = context_.vocabulary();
    const Symbol declared = file.name_of(statement);
    const std::string_view name = context_.text(declared);
    const bool is_template = statement.kind == ast::Statement::Kind::def;
    if (is_template && vocabulary.in_statements().knows(declared)) {
        context_.report.error(Message::template_takes_word, place, name);
        return;
    }
    if (is_template && vocabulary.is_block(declared))
        context_.report.warning(Message::template_and_block, place, name, name);
    if (names_.function(declared) != nullptr)
        context_.report.warning(Message::hides_function, place, name);
    Binding binding;
    binding.kind = is_template ? Binding::Kind::definition : Binding::Kind::function;
    binding.name = declared;
    binding.place = place;
    binding.file = &file;
    binding.definition = &statement;
    if (!has_new_parameters({file, statement})) binding.kind = Binding::Kind::broken_definition;
    names_.declare(std::move(binding));
}

/// Reports parameters with equal names. False when there are any.
bool TemplateCalls::has_new_parameters(const Parameters& parameters) const {
    bool good = true;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        std::size_t first = 0;
        while (parameters[first].name != parameters[i].name) ++first;
        if (first == i) continue;
        good = false;
        const ast::File& file = parameters.file();
        Diagnostic* error = context_.report.error(
            Message::already_defined, file.span(parameters[i]), context_.text(parameters[i].name));
        if (error != nullptr)
            error->notes.insert(error->notes.begin(),
                                Report::note(Message::first_here, file.span(parameters[first])));
    }
    return good;
}

/// nullptr: the name is not a template, which was reported.
const Binding* TemplateCalls::find_template(const ast::Statement& call,
                                            const SourceSpan& place) const {
    const Symbol name = call.word;
    const Binding* callee = names_.scopes().find_callable(name);
    if (callee != nullptr && callee->kind == Binding::Kind::definition) return callee;
    if (callee != nullptr && callee->kind == Binding::Kind::broken_definition) return nullptr;
    if (callee != nullptr || names_.function(name) != nullptr) {
        context_.report.error(Message::function_as_statement, place, context_.text(name));
    } else if (context_.vocabulary().is_block(name)) {
        context_.report.error(Message::block_as_call, place, context_.text(name));
    } else {
        const bool has_value = names_.scopes().find(name) != nullptr;
        names_.report_undefined(has_value ? Message::not_a_template : Message::function_not_defined,
                                place, name, true);
    }
    return nullptr;
}

std::optional<TemplateCalls::Entered> TemplateCalls::enter(const ast::File& file,
                                                           const ast::Statement& call) {
    const SourceSpan place = file.span(call);
    const Binding* callee = find_template(call, place);
    if (callee == nullptr) return std::nullopt;
    const ast::File& home = *callee->file;
    const ast::Statement& definition = *callee->definition;
    const Parameters parameters(home, definition);
    std::vector<Given> given;
    if (!match(file, call, parameters, given)) return std::nullopt;
    if (!are_complete(parameters, place, given)) return std::nullopt;
    context_.enter_call(place, context_.text(call.word));
    // Calls in the arguments may have moved the bindings, so the template is looked up again.
    Scopes& scopes = names_.scopes();
    const Scopes::Caller caller = scopes.enter(*scopes.find_callable(call.word));
    scopes.open();
    bind(parameters, given);
    return Entered{home, definition, caller};
}

void TemplateCalls::leave(const Scopes::Caller& caller) {
    names_.scopes().close();
    names_.scopes().leave(caller);
    context_.leave_call();
}

bool TemplateCalls::match(const ast::File& file, const ast::Statement& call,
                          const Parameters& parameters, std::vector<Given>& given) {
    given.resize(parameters.size());
    bool good = true;
    bool named = false;
    const ast::Range& arguments = file.parts_of(call).arguments;
    for (std::uint32_t i = 0; i < arguments.size(); ++i) {
        const ast::Argument& argument = file.arguments[arguments.begin + i];
        Value value = expressions_.evaluate(file, argument.value);
        if (argument.name != no_symbol) {
            named = true;
            good &= parameters.give(argument.name, std::move(value), given, file.span(argument),
                                    context_);
        } else if (named) {
            good = false;
            context_.report.error(Message::positional_after_named, file.span(argument.value));
        } else if (i >= parameters.size()) {
            good = false;
            context_.report.error(Message::too_many_arguments, file.span(argument.value),
                                  context_.text(call.word), arguments_text(parameters.size()),
                                  arguments.size());
        } else {
            given[i] = {std::move(value), true};
        }
    }
    return good;
}

/// Reports parameters without a value and a default. False when there are any.
bool TemplateCalls::are_complete(const Parameters& parameters, const SourceSpan& call,
                                 const std::vector<Given>& given) const {
    bool complete = true;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (given[i].is_given || !parameters[i].value.empty()) continue;
        complete = false;
        context_.report.error(Message::missing_argument, call, context_.text(parameters.name()),
                              context_.text(parameters[i].name));
    }
    return complete;
}

/// In the scope of the call: binds the given values and evaluates the other defaults, which may use
/// earlier parameters.
void TemplateCalls::bind(const Parameters& parameters, std::vector<Given>& given) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const ast::Argument& parameter = parameters[i];
        Value value = given[i].is_given ? std::move(given[i].value)
                                        : expressions_.evaluate(parameters.file(), parameter.value);
        names_.scopes().bind(parameter_binding(parameters.file(), parameter, std::move(value)));
    }
}

}  // namespace lancer
