#include "parser/evaluation/iteration.h"

#include <cmath>

namespace lancer {

bool is_range_bound(const Value& value, const SourceSpan& place, Report& report) {
    constexpr double most = 9007199254740992.0;  // above 2^53, doubles skip whole numbers
    if (value.is_broken()) return false;
    if (value.is_number() && value.number() == std::floor(value.number()) &&
        std::abs(value.number()) <= most)
        return true;
    report.error(Message::range_bound, place, describe(value));
    return false;
}

}  // namespace lancer
