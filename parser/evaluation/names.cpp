#include "parser/evaluation/names.h"

#include "parser/habits.h"
#include "parser/suggest.h"

namespace lancer {

Names::Names(const Context& context) : context_(context) {
    Symbols& symbols = context.program.symbols;
    for (const Constant& constant : all_constants())
        set_constant(symbols.intern(constant.name), constant.value);
}

const Value& Names::value_of(const ast::File& file, const ast::Step& step) const {
    const Symbol name = step.low();
    Report& report = context_.report;
    if (const Binding* binding = scopes_.find(name)) {
        if (binding->kind == Binding::Kind::definition)
            report.error(Message::template_as_value, file.span(step), context_.text(name));
        if (binding->kind == Binding::Kind::function)
            report.error(Message::function_as_value, file.span(step), context_.text(name));
        return binding->value;
    }
    if (const auto constant = constants_.find(name); constant != constants_.end())
        return constant->second;
    if (function(name) != nullptr) {
        report.error(Message::function_as_value, file.span(step), context_.text(name));
    } else {
        report_undefined(Message::name_not_defined, file.span(step), name, false);
    }
    return broken_;
}

bool Names::declare(Binding binding) {
    if (const Binding* first = scopes_.find_here(binding.name)) {
        Diagnostic* error = context_.report.error(Message::already_defined, binding.place,
                                                  context_.text(binding.name));
        if (error != nullptr)
            error->notes.insert(error->notes.begin(),
                                Report::note(Message::first_here, first->place));
        return false;
    }
    scopes_.bind(std::move(binding));
    return true;
}

/// The place where the same file defines an undefined name: later, or within other braces.
SourceSpan Names::place_of_definition(const SourceSpan& use, Symbol name) const {
    const Program& program = context_.program;
    const ast::File* file = program.main.source == use.file ? &program.main : nullptr;
    for (const auto& [path, script] : program.scripts)
        if (script.file != nullptr && script.file->source == use.file) file = script.file.get();
    if (file == nullptr) return {};
    using Kind = ast::Statement::Kind;
    const Vocabulary& vocabulary = context_.vocabulary();
    for (const ast::Statement& s : file->statements) {
        const bool names_value = s.kind == Kind::block &&
                                 (s.word == vocabulary.material || s.word == vocabulary.texture);
        if (file->name_of(s) == name &&
            (names_value || s.kind == Kind::let || s.kind == Kind::param || s.kind == Kind::def ||
             s.kind == Kind::func))
            return file->name_span(s);
    }
    return {};
}

void Names::report_undefined(Message message, const SourceSpan& place, Symbol name,
                             bool functions) const {
    const std::string_view word = context_.text(name);
    Diagnostic* error = context_.report.error(message, place, word);
    if (error == nullptr) return;
    if (const SourceSpan later = place_of_definition(place, name);
        later.file != SourceSpan::nowhere) {
        const bool is_later = later.offset > place.offset;
        error->notes.insert(
            error->notes.begin(),
            Report::note(is_later ? Message::defined_later : Message::defined_elsewhere, later));
        if (is_later) error->hint = "a name must be defined before it is used";
        return;
    }
    if (std::string color = habits::color_called(word); !color.empty() && !functions) {
        error->hint = std::move(color);
        return;
    }
    if (const std::string_view instead = habits::instead_of(word); !instead.empty()) {
        error->hint = instead;
        return;
    }
    Suggestion suggestion(word);
    scopes_.for_each_visible([&](const Binding& binding) {
        if ((binding.kind == Binding::Kind::value) != functions)
            suggestion.consider(context_.text(binding.name));
    });
    if (functions) {
        for (const Function& f : all_functions()) suggestion.consider(f.name);
    } else {
        for (const auto& [symbol, value] : constants_) suggestion.consider(context_.text(symbol));
    }
    error->hint = suggestion.hint();
}

}  // namespace lancer
