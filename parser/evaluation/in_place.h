// A material or texture that stands where a value does.
#pragma once

#include "parser/evaluation/block_context.h"
#include "parser/evaluation/executed.h"
#include "parser/evaluation/expressions.h"

namespace lancer {

class BlocksInPlace final : public InPlaceMaker {
  public:
    BlocksInPlace(const BlockContext& context, Executed& executed)
        : context_(context), executed_(executed) {}

    Value make(const ast::File& file, std::uint32_t statement) override;

  private:
    const BlockContext& context_;
    Executed& executed_;
    std::uint64_t depth_ = 0;  ///< how deep blocks in place are nested
};

}  // namespace lancer
