// Text → AST.
#pragma once

#include <cstdint>
#include <string_view>

#include "model/source.h"
#include "parser/ast.h"
#include "parser/report.h"
#include "parser/symbols.h"
#include "parser/vocabulary.h"

namespace lancer {

/// Adds a script to the map, without its byte order mark.
std::uint32_t add_source(SourceMap& sources, std::string name, std::string text);

/// Parses the file `source` of `sources`. Errors go to `report`; the result holds the statements
/// that could be read. Throws StopReading when there are too many errors.
ast::File read_syntax(std::uint32_t source, const SourceMap& sources, Symbols& symbols,
                      const Vocabulary& vocabulary, std::uint64_t nesting_limit, Report& report);

/// Parses a text that holds one expression; the result's `statements` are empty. Returns an empty
/// expression after an error.
ast::Expression read_expression(ast::File& file, const SourceMap& sources, Symbols& symbols,
                                const Vocabulary& vocabulary, std::uint64_t nesting_limit,
                                Report& report);

}  // namespace lancer
