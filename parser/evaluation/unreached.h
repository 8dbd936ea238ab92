// Checks code that no run reaches (a template that nobody calls, the other branch of an `if`), as
// far as that is possible without running it: blocks by their tables, and names against all names
// that any file defines.
#pragma once

#include <unordered_set>
#include <vector>

#include "parser/evaluation/block_context.h"
#include "parser/evaluation/executed.h"
#include "parser/evaluation/includes.h"
#include "parser/evaluation/names.h"

namespace lancer {

class Unreached {
  public:
    Unreached(const BlockContext& context, Executed& executed, Includes& includes)
        : context_(context), executed_(executed), includes_(includes) {}

    /// To be called after the run.
    void check();

  private:
    std::vector<const ast::File*> files() const;
    void collect_names(const ast::File& file);
    void find_missed_includes(const ast::File& file);
    void check_blocks(const ast::File& file);
    void check_words(const ast::File& file);
    void check_names(const ast::File& file, const ast::Expression& expression, bool lone_word);
    bool is_known(Symbol name) const {
        return declared_.contains(name) || context_.names.function(name) != nullptr;
    }

    const BlockContext& context_;
    Executed& executed_;
    Includes& includes_;
    std::unordered_set<Symbol> declared_;  ///< all names that any file declares
};

}  // namespace lancer
