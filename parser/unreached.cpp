// Code that no run reaches (a template that nobody calls, the other side of an `if`) is checked as
// far as it can be without running it: blocks by their tables, names against all that stand in any
// file.
#include "parser/block_reader.h"
#include "parser/evaluator.h"

namespace lancer {

using Kind = ast::Statement::Kind;

void Evaluator::mark_executed(const ast::File& file, std::uint32_t statement) {
    if (marked_file_ != &file) {
        marked_file_ = &file;
        marks_ = &executed_[&file];
        marks_->resize(file.statements.size());
    }
    (*marks_)[statement] = true;
}

void Evaluator::collect_names(const ast::File& file) {
    for (const ast::Statement& statement : file.statements) declared_.insert(statement.name);
    for (const ast::Argument& argument : file.arguments) declared_.insert(argument.name);
    declared_.insert(file.variables.begin(), file.variables.end());
}

/// `lone_word`: the expression may be one word of a property that takes words.
void Evaluator::check_names(const ast::File& file, const ast::Expression& expression,
                            bool lone_word) {
    if (lone_word && expression.end - expression.begin == 1) return;
    for (std::uint32_t i = expression.begin; i < expression.end; ++i) {
        const ast::Step& step = file.steps[i];
        if (step.op == ast::Op::skip) i = step.low();  // these statements are looked at themselves
        const bool call = step.op == ast::Op::call;
        if (!call && step.op != ast::Op::name) continue;
        const Symbol name = step.low();
        const bool function = name < functions_.size() && functions_[name] != nullptr;
        if (declared_.contains(name) || function || constants_.contains(name)) continue;
        report_undefined(call ? Message::function_not_defined : Message::name_not_defined,
                         file.span(step), name, call);
    }
}

void Evaluator::check_unreached(const ast::File& file) {
    const Vocabulary& vocabulary = program_.vocabulary;
    std::vector<bool>& executed = executed_[&file];
    executed.resize(file.statements.size());
    // The properties of a block that was executed were read with it.
    for (std::uint32_t i = 0; i < file.statements.size(); ++i) {
        const ast::Statement& statement = file.statements[i];
        // What stands at file level was reached.
        if (!executed[i] && statement.kind == Kind::param)
            report_.error(Message::param_not_at_top, file.span(statement));
        const bool holds_properties =
            statement.kind == Kind::block && !vocabulary.holds_statements(statement.word);
        if (!holds_properties) continue;
        if (!executed[i] && vocabulary.block(statement.word, statement.name) != nullptr)
            BlockReader(*this, file, statement, *vocabulary.block(statement.word, statement.name))
                .check();
        if (!executed[i]) continue;
        // Nested materials stand before their block, so go on inwards from here.
        for (std::uint32_t j = statement.body.begin; j < statement.body.end; ++j) {
            executed[j] = true;
            const ast::Range inner = file.statements[j].body;
            for (std::uint32_t k = inner.begin; k < inner.end; ++k) executed[k] = true;
        }
    }
    if (incomplete_) return;  // names may stand in a file that could not be read
    for (std::uint32_t i = 0; i < file.statements.size(); ++i) {
        const ast::Statement& statement = file.statements[i];
        if (executed[i]) continue;
        if (statement.kind == Kind::block && !vocabulary.holds_statements(statement.word) &&
            vocabulary.block(statement.word, statement.name) == nullptr)
            report_unknown_block(file, statement);
        if (statement.kind == Kind::call && !declared_.contains(statement.word) &&
            (statement.word >= functions_.size() || functions_[statement.word] == nullptr))
            report_undefined(Message::function_not_defined, file.span(statement), statement.word,
                             true);
        const bool word = statement.kind == Kind::property && vocabulary.takes_word(statement.word);
        check_names(file, statement.value, word);
        for (std::uint32_t j = statement.arguments.begin; j < statement.arguments.end; ++j)
            check_names(file, file.arguments[j].value, false);
    }
}

void Evaluator::check_unreached() {
    std::vector<const ast::File*> files{&program_.main};
    for (const auto& [path, script] : program_.scripts)
        if (script.file != nullptr && executed_.contains(script.file.get()))
            files.push_back(script.file.get());
    for (const ast::File* file : files) {
        collect_names(*file);
        const std::vector<bool>& executed = executed_[file];
        for (std::uint32_t i = 0; i < file->statements.size(); ++i)
            incomplete_ |=
                file->statements[i].kind == Kind::include && (i >= executed.size() || !executed[i]);
    }
    for (const ast::File* file : files) check_unreached(*file);
}

}  // namespace lancer
