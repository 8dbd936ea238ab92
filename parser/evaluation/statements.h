// Runs statements on a stack of frames, so that deep scripts never need a deep stack of the program
// itself.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "parser/evaluation/block_statements.h"
#include "parser/evaluation/executed.h"
#include "parser/evaluation/expressions.h"
#include "parser/evaluation/includes.h"
#include "parser/evaluation/iteration.h"
#include "parser/evaluation/params.h"
#include "parser/evaluation/template_calls.h"

namespace lancer {

class Statements {
  public:
    Statements(const BlockContext& context, Names& names, Executed& executed, Includes& includes,
               Params& params)
        : context_(context),
          names_(names),
          executed_(executed),
          includes_(includes),
          params_(params),
          templates_(context, names, context.expressions),
          groups_(context),
          blocks_(context, names, groups_) {}

    /// Runs a file. Throws StopReading when a limit was passed.
    void run(const ast::File& file);

    std::vector<std::string> take_printed() { return std::move(printed_); }

  private:
    /// A range of statements that is being executed, and what to do at its end.
    struct Frame {
        enum class Kind : std::uint8_t { body, loop, call, group, include };
        Kind kind = Kind::body;
        bool file_level = false;  ///< params are allowed here
        const ast::File* file = nullptr;
        std::uint32_t first = 0, next = 0, end = 0;
        const ast::Statement* loop = nullptr;
        Iteration iteration;              ///< of a loop
        Scopes::Caller caller;            ///< of a call
        Groups::Open outer_group = none;  ///< of a call or group
    };

    void step();
    void execute(const ast::File& file, const ast::Statement& statement);
    Frame& push(Frame::Kind kind, const ast::File& file, const ast::Range& body);
    void end_frame();
    bool next_iteration(Frame& frame);

    void execute_let(const ast::File& file, const ast::Statement& statement);
    void execute_param(const ast::File& file, const ast::Statement& statement);
    void execute_broken(const ast::File& file, const ast::Statement& statement);
    void execute_loop(const ast::File& file, const ast::Statement& statement);
    void execute_choice(const ast::File& file, const ast::Statement& statement);
    void execute_include(const ast::File& file, const ast::Statement& statement);
    void execute_assertion(const ast::File& file, const ast::Statement& statement);
    void execute_print(const ast::File& file, const ast::Statement& statement);
    void execute_block(const ast::File& file, const ast::Statement& statement);
    void execute_call(const ast::File& file, const ast::Statement& statement);
    bool condition(const ast::File& file, const ast::Expression& expression, std::string_view what,
                   bool& result);

    const BlockContext& context_;
    Names& names_;
    Executed& executed_;
    Includes& includes_;
    Params& params_;
    TemplateCalls templates_;
    Groups groups_;
    BlockStatements blocks_;
    std::vector<Frame> frames_;
    std::vector<std::string> printed_;
};

}  // namespace lancer
