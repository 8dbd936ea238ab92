// The scripts that a script includes: each runs once, and none includes itself.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "parser/evaluation/context.h"
#include "parser/evaluation/files.h"

namespace lancer {

class Includes {
  public:
    Includes(const Context& context, Files& files);

    /// The script that an `include` names; it counts as open until leave(). nullptr: nothing is to
    /// be run, after an error or because the script was included before.
    const ast::File* enter(const ast::File& file, const ast::Statement& statement,
                           const Value& name);
    void leave();

    /// Whether a script could not be read, so that its definitions are unknown.
    bool is_incomplete() const { return incomplete_; }
    /// Records an include that the run did not reach.
    void miss() { incomplete_ = true; }

  private:
    bool is_cycle(const std::string& key, const SourceSpan& place) const;
    const ast::File* load(const std::string& path, const std::string& key, const SourceSpan& place,
                          const SourceSpan& statement);

    const Context context_;
    Files& files_;
    std::unordered_set<std::string> included_;
    std::vector<std::string> including_;  ///< chain of paths, the main script first
    bool incomplete_ = false;
};

}  // namespace lancer
