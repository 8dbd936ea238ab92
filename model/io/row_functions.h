// The source of rows and the destination of bytes for pictures that are encoded row by row.
#pragma once

#include <functional>
#include <string_view>

namespace lancer::io {

/// The samples of row y, as RowEncoder stores them, valid until the next call. Called once for each
/// row, from the top.
using RowOf = std::function<const char*(int y)>;

/// The same for `count` encoded rows in sequence.
using RowsOf = std::function<const void*(int first, int count)>;

/// Receives the bytes of a file in order.
using AddBytes = std::function<void(std::string_view bytes)>;

}  // namespace lancer::io
