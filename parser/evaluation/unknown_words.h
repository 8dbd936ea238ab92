// What is said of a block or property that no table has.
#pragma once

#include <string>
#include <string_view>

#include "parser/evaluation/context.h"
#include "parser/evaluation/names.h"

namespace lancer {

/// "a sphere", "an image".
std::string with_article(const std::string& title);

/// A property that the block called `title` does not know. Returns the property that was probably
/// meant, if there is one.
std::string_view report_unknown_property(const ast::File& file, const ast::Statement& property,
                                         const PropertySet& known, const std::string& title,
                                         const Context& context);
/// A property where no block is open that takes it: in a file, a template.
void report_stray_property(const ast::File& file, const ast::Statement& property,
                           const Context& context);
void report_unknown_block(const ast::File& file, const ast::Statement& block, const Names& names,
                          const Context& context);

}  // namespace lancer
