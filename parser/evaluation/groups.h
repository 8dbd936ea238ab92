// The groups, unions, intersections and differences that are open, and the properties they take.
#pragma once

#include <cstdint>
#include <vector>

#include "parser/ast.h"
#include "parser/evaluation/block_context.h"
#include "parser/scene_builder.h"

namespace lancer {

class Groups {
  public:
    explicit Groups(const BlockContext& context) : context_(context) {}

    /// What is open is told apart by a number; `none`: nothing whose properties may stand here.
    using Open = std::uint32_t;

    /// Opens the group of a block of statements. Returns what was open: for close().
    Open open(const ast::File& file, const ast::Statement& statement, const BlockWord& word);
    void close(Open outer);
    /// In a template no property of a group around the call may stand. For show().
    Open hide();
    void show(Open outer) { open_ = outer; }

    bool any() const { return open_ != none; }
    /// Reads a property of the group that is open. False: there is none, or it is no property of
    /// groups.
    bool take_property(const ast::File& file, const ast::Statement& property);
    void take_material(const ast::File& file, const ast::Statement& material);
    /// Reports a property that the group which is open does not know.
    void report_unknown(const ast::File& file, const ast::Statement& property) const;

  private:
    struct Group {
        Symbol keyword = no_symbol;  ///< group, union, intersection, difference
        Attributes attributes;
        std::vector<SourceSpan> given;  ///< by index of the property
    };

    const PropertySet& properties() const;

    const BlockContext& context_;
    std::vector<Group> groups_;
    Open open_ = none;
};

}  // namespace lancer
