// A loop over a list or a range, of a `for` statement or of a `for` within a list.
#pragma once

#include <cstdint>
#include <utility>

#include "parser/report.h"
#include "parser/value.h"

namespace lancer {

struct Iteration {
    Value list;
    double start = 0;  ///< of a range
    std::uint64_t position = 0, count = 0;
    bool is_range = false;

    /// The whole numbers from `from` to `to`, without `to`.
    static Iteration range(double from, double to) {
        Iteration made;
        made.is_range = true;
        made.start = from;
        made.count = to > from ? static_cast<std::uint64_t>(to - from) : 0;
        return made;
    }
    static Iteration over(Value list) {
        Iteration made;
        made.count = list.size();
        made.list = std::move(list);
        return made;
    }

    bool at_end() const { return position == count; }
    Value value() const {
        return is_range ? Value(start + static_cast<double>(position)) : list.at(position);
    }
};

/// Whether a range may begin or end at this value. Reports an error if not.
bool is_range_bound(const Value& value, const SourceSpan& place, Report& report);

}  // namespace lancer
