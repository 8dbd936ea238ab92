// Runs an AST: puts the parts of an evaluation together.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "parser/evaluation/block_context.h"
#include "parser/evaluation/executed.h"
#include "parser/evaluation/expressions.h"
#include "parser/evaluation/files.h"
#include "parser/evaluation/in_place.h"
#include "parser/evaluation/includes.h"
#include "parser/evaluation/names.h"
#include "parser/evaluation/params.h"
#include "parser/evaluation/singles.h"
#include "parser/evaluation/statements.h"
#include "parser/scene_builder.h"

namespace lancer {

class Evaluator {
  public:
    Evaluator(Program& program, const Definitions& definitions, const Limits& limits,
              SourceMap& sources, Report& report, const Loader& loader);
    // Its parts refer to each other.
    Evaluator(const Evaluator&) = delete;
    Evaluator& operator=(const Evaluator&) = delete;

    /// The values of the command line's -D options. Needs an evaluator of its own, whose report is
    /// about the command line.
    std::vector<std::pair<Symbol, Value>> evaluate_definitions();
    /// Gives params these values, before run().
    void define(const std::vector<std::pair<Symbol, Value>>& values) { params_.define(values); }
    /// Runs the main file. Throws StopReading when a limit was passed.
    void run() { statements_.run(context_.program.main); }
    /// After run(): checks code that was not executed, as far as that is possible without running
    /// it.
    void check_unreached();
    /// Reports -D options that name no param. To be called after check_unreached().
    void check_definitions(Report& usage);

    const SceneBuilder& builder() const { return builder_; }
    Scene take_scene() { return std::move(builder_.scene); }
    std::vector<std::string> take_printed() { return statements_.take_printed(); }

  private:
    const Definitions& definitions_;
    Meter meter_;
    const Context context_;
    SceneBuilder builder_;
    Singles singles_;
    Executed executed_;
    Names names_;
    Files files_;
    Includes includes_;
    Params params_;
    // Blocks in place read properties, whose values are expressions: so each refers to the other.
    BlocksInPlace in_place_;
    Expressions expressions_;
    const BlockContext block_context_;
    Statements statements_;
};

}  // namespace lancer
