#include "parser/evaluation/unreached.h"

#include "parser/evaluation/block_reader.h"
#include "parser/evaluation/unknown_words.h"

namespace lancer {

using Kind = ast::Statement::Kind;

void Unreached::check() {
    const std::vector<const ast::File*> all = files();
    for (const ast::File* file : all) {
        collect_names(*file);
        find_missed_includes(*file);
    }
    for (const ast::File* file : all) {
        check_blocks(*file);
        if (!includes_.is_incomplete())
            check_words(*file);  // else the missing files may define the names
    }
}

/// Files of which at least a part ran.
std::vector<const ast::File*> Unreached::files() const {
    const Program& program = context_.program;
    std::vector<const ast::File*> all{&program.main};
    for (const auto& [path, script] : program.scripts)
        if (script.file != nullptr && executed_.holds(*script.file))
            all.push_back(script.file.get());
    return all;
}

void Unreached::collect_names(const ast::File& file) {
    for (const ast::Parts& parts : file.parts) declared_.insert(parts.name);
    for (const ast::Argument& argument : file.arguments) declared_.insert(argument.name);
    declared_.insert(file.variables.begin(), file.variables.end());
}

void Unreached::find_missed_includes(const ast::File& file) {
    const std::vector<bool>& executed = executed_.of(file);
    for (std::uint32_t i = 0; i < file.statements.size(); ++i)
        if (file.statements[i].kind == Kind::include && !executed[i]) includes_.miss();
}

/// Checks blocks by their tables. Marks the properties of executed blocks as executed.
void Unreached::check_blocks(const ast::File& file) {
    const Vocabulary& vocabulary = context_.vocabulary();
    std::vector<bool>& executed = executed_.of(file);
    for (std::uint32_t i = 0; i < file.statements.size(); ++i) {
        const ast::Statement& statement = file.statements[i];
        // All statements at file level were reached, so this param stands deeper.
        if (!executed[i] && statement.kind == Kind::param)
            context_.report.error(Message::param_not_at_top, file.span(statement));
        const bool holds_properties =
            statement.kind == Kind::block && !vocabulary.holds_statements(statement.word);
        if (!holds_properties) continue;
        if (!executed[i]) {
            const BlockWord* word = vocabulary.block(statement.word, file.name_of(statement));
            if (word != nullptr) BlockReader(context_, file, statement, *word).check();
            continue;
        }
        // Nested materials stand before their block in the array, so go on inwards from here.
        const ast::Range body = file.parts_of(statement).body;
        for (std::uint32_t j = body.begin; j < body.end; ++j) {
            executed[j] = true;
            const ast::Range inner = file.parts_of(file.statements[j]).body;
            for (std::uint32_t k = inner.begin; k < inner.end; ++k) executed[k] = true;
        }
    }
}

/// Checks for words that no table has, and for names that are defined nowhere.
void Unreached::check_words(const ast::File& file) {
    const Vocabulary& vocabulary = context_.vocabulary();
    const std::vector<bool>& executed = executed_.of(file);
    for (std::uint32_t i = 0; i < file.statements.size(); ++i) {
        const ast::Statement& statement = file.statements[i];
        if (executed[i]) continue;
        if (statement.kind == Kind::block && !vocabulary.holds_statements(statement.word) &&
            vocabulary.block(statement.word, file.name_of(statement)) == nullptr)
            report_unknown_block(file, statement, context_.names, context_);
        if (statement.kind == Kind::call && !is_known(statement.word))
            context_.names.report_undefined(Message::function_not_defined, file.span(statement),
                                            statement.word, true);
        const bool word = statement.kind == Kind::property && vocabulary.takes_word(statement.word);
        check_names(file, statement.value, word);
        const ast::Range arguments = file.parts_of(statement).arguments;
        for (std::uint32_t j = arguments.begin; j < arguments.end; ++j)
            check_names(file, file.arguments[j].value, false);
    }
}

/// `lone_word`: the expression may be one word, for a property that takes words.
void Unreached::check_names(const ast::File& file, const ast::Expression& expression,
                            bool lone_word) {
    if (lone_word && expression.end - expression.begin == 1) return;
    for (std::uint32_t i = expression.begin; i < expression.end; ++i) {
        const ast::Step& step = file.steps[i];
        if (step.op == ast::Op::skip) i = step.low();  // the loop over all statements checks these
        const bool call = step.op == ast::Op::call;
        if (!call && step.op != ast::Op::name) continue;
        const Symbol name = step.low();
        if (is_known(name) || context_.names.is_constant(name)) continue;
        context_.names.report_undefined(
            call ? Message::function_not_defined : Message::name_not_defined, file.span(step), name,
            call);
    }
}

}  // namespace lancer
