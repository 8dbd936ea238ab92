// Messages about blocks and properties that no table has.
#pragma once

#include <string>
#include <string_view>

#include "parser/evaluation/context.h"
#include "parser/evaluation/names.h"

namespace lancer {

/// "a sphere", "an image".
std::string with_article(const std::string& title);

/// Reports a property that the block called `title` does not have. Returns the property that was
/// probably meant, or an empty word.
std::string_view report_unknown_property(const ast::File& file, const ast::Statement& property,
                                         const PropertySet& known, const std::string& title,
                                         const Context& context);
/// Reports a property where no open block takes it: in a file or a template.
void report_stray_property(const ast::File& file, const ast::Statement& property,
                           const Context& context);
void report_unknown_block(const ast::File& file, const ast::Statement& block, const Names& names,
                          const Context& context);

}  // namespace lancer
