// Pictures that are encoded row by row: where the rows come from, and where the bytes go.
#pragma once

#include <functional>
#include <string_view>

namespace lancer::io {

/// The pixels of row y, as they stand in Image::data, until the next call. Each is asked for once,
/// from the top.
using RowOf = std::function<const double*(int y)>;

/// The same for `count` rows that are encoded already, one after the other.
using RowsOf = std::function<const void*(int first, int count)>;

/// Takes the bytes of a file, in their order.
using AddBytes = std::function<void(std::string_view bytes)>;

}  // namespace lancer::io
