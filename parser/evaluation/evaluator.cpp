#include "parser/evaluation/evaluator.h"

#include "parser/evaluation/unreached.h"
#include "parser/syntax.h"

namespace lancer {

Evaluator::Evaluator(Program& program, const Definitions& definitions, const Limits& limits,
                     SourceMap& sources, Report& report, const Loader& loader)
    : definitions_(definitions),
      meter_(limits, report),
      context_{program, sources, report, meter_},
      builder_(meter_, report),
      singles_(report),
      names_(context_),
      files_(context_, loader),
      includes_(context_, files_),
      params_(context_, definitions, names_),
      in_place_(block_context_, executed_),
      expressions_(context_, names_, executed_, in_place_),
      block_context_{context_, expressions_, names_, files_, builder_, singles_},
      statements_(block_context_, names_, executed_, includes_, params_) {
    const std::uint32_t main = program.main.source;
    meter_.source(sources.text(main).size(), {main, 0, 0});
}

std::vector<std::pair<Symbol, Value>> Evaluator::evaluate_definitions() {
    std::vector<std::pair<Symbol, Value>> values;
    Program& program = context_.program;
    for (const auto& [name, source] : definitions_.values) {
        ast::File file;
        file.source = context_.sources.add("-D " + name, source);
        const ast::Expression expression =
            read_expression(file, context_.sources, program.symbols, program.vocabulary,
                            meter_.limits().nesting, context_.report);
        // The block would go into this evaluator's scene, which is not used.
        Value value(0.0);
        if (!file.statements.empty())
            context_.report.error(Message::definition_is_block, file.span(expression));
        else
            value = expressions_.evaluate(file, expression);
        values.emplace_back(program.symbols.intern(name), std::move(value));
    }
    return values;
}

void Evaluator::check_unreached() {
    Unreached(block_context_, executed_, includes_).check();
}

void Evaluator::check_definitions(Report& usage) {
    // else the missing file may declare the param
    if (!includes_.is_incomplete()) params_.check(usage);
}

}  // namespace lancer
