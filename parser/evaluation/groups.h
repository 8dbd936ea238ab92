// The open groups, unions, intersections and differences, and their properties.
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

    /// The index of the open group; `none`: no group whose properties may stand here.
    using Open = std::uint32_t;

    /// Opens the group of a block of statements. Returns the group that was open, for close().
    Open open(const ast::File& file, const ast::Statement& statement, const BlockWord& word);
    void close(Open outer);
    /// Hides the open group: a template must not set properties of a group around its call. Returns
    /// the group that was open, for show().
    Open hide();
    void show(Open outer) { open_ = outer; }

    bool any() const { return open_ != none; }
    /// Reads a property of the open group. False: no group is open, or groups have no such
    /// property.
    bool take_property(const ast::File& file, const ast::Statement& property);
    void take_material(const ast::File& file, const ast::Statement& material);
    /// Reports a property that the open group does not have.
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
