// Statements that are blocks or properties, in files, groups and templates.
#pragma once

#include "parser/evaluation/block_context.h"
#include "parser/evaluation/groups.h"
#include "parser/evaluation/names.h"

namespace lancer {

class BlockStatements {
  public:
    BlockStatements(const BlockContext& context, Names& names, Groups& groups)
        : context_(context), names_(names), groups_(groups) {}

    void read_property(const ast::File& file, const ast::Statement& statement);
    /// Makes the object of a block. For a block that holds statements, returns the block, and the
    /// caller runs these statements; otherwise returns nullptr.
    const BlockWord* read_block(const ast::File& file, const ast::Statement& statement);

  private:
    void read_property_of_file(const ast::File& file, const ast::Statement& statement,
                               const Field& field);
    void make(const ast::File& file, const ast::Statement& statement, const BlockWord& word);

    const BlockContext& context_;
    Names& names_;
    Groups& groups_;
};

}  // namespace lancer
