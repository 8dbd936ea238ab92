// What a name in an expression means, and what is said where it means nothing.
#include "parser/evaluator.h"
#include "parser/habits.h"
#include "parser/suggest.h"

namespace lancer {

bool Evaluator::has_value(Symbol name) const {
    return scopes_.find(name) != nullptr || constants_.contains(name);
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
        if (s.name == name && (names_value || s.kind == Kind::let || s.kind == Kind::param ||
                               s.kind == Kind::def || s.kind == Kind::func))
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
    if (std::string color = habits::color_called(text(name)); !color.empty() && !functions) {
        error->hint = std::move(color);
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
        if (binding->kind == Binding::Kind::function)
            report_.error(Message::function_as_value, file.span(step), text(name));
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

}  // namespace lancer
