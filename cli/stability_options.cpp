#include "cli/stability_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/arguments.h"
#include "cli/session.h"

namespace lancer::cli {
namespace {

using judge::Change;

/// The range of doubles, with room for the scene's own size.
constexpr int most_decades = 300;
constexpr int most_doublings = 1000;

int largest_exponent(Change change) {
    return base_of(change) == 2 ? most_doublings : most_decades;
}

Change parse_change(const std::string& word) {
    std::string names;
    for (const Change change : judge::all_changes) {
        if (word == name_of(change)) return change;
        names += (names.empty() ? "" : ", ") + std::string(name_of(change));
    }
    throw UsageError(
        fmt::format("'{}' is not a change of a scene: expected one of {}", word, names));
}

/// The exponent of `base` whose power is this number; it need not be a whole number.
double exponent_of(const std::string& text, int base) {
    const std::size_t power = text.find('^');
    if (power != std::string::npos) {
        const double given_base = parse_number(text.substr(0, power));
        const double exponent = parse_number(text.substr(power + 1));
        if (given_base != 2 && given_base != 10)
            throw UsageError(fmt::format("'{}': a power must have the base 2 or 10", text));
        return given_base == base ? exponent
                                  : exponent * std::log(given_base) / std::log(double(base));
    }
    const double value = parse_number(text);
    if (!(value > 0)) throw UsageError(fmt::format("'{}' must be greater than 0", text));
    const double exponent = base == 2 ? std::log2(value) : std::log10(value);
    // A whole exponent is exact, whatever the last digit of the logarithm.
    const double whole = std::round(exponent);
    return std::abs(exponent - whole) < 1e-9 ? whole : exponent;
}

int bounded(double exponent, const ChangeRange& range) {
    const int limit = largest_exponent(range.change);
    if (!(std::abs(exponent) <= limit))
        throw UsageError(fmt::format("'{}': exponents of {} must be between {} and {}", range.text,
                                     base_of(range.change), -limit, limit));
    return static_cast<int>(exponent);
}

}  // namespace

ChangeRange parse_change_range(const std::string& text) {
    ChangeRange range;
    range.text = text;
    const std::size_t equals = text.find('=');
    range.change = parse_change(text.substr(0, equals));
    if (equals == std::string::npos) return range;
    const int base = base_of(range.change);
    const std::string name = name_of(range.change);
    if (base == 0) throw UsageError(fmt::format("'{}': {} takes no range", text, name));
    const std::string ends = text.substr(equals + 1);
    const std::size_t dots = ends.find("..");
    const bool two_sided = range.change == Change::scale || range.change == Change::twos;
    if (dots == std::string::npos) {
        if (two_sided)
            throw UsageError(fmt::format(
                "'{0}' is not a range: expected {1}=A..B, as in {1}=1e-6..1e6", text, name));
        range.high = bounded(std::ceil(exponent_of(ends, base)), range);
    } else {
        range.low = bounded(std::floor(exponent_of(ends.substr(0, dots), base)), range);
        range.high = bounded(std::ceil(exponent_of(ends.substr(dots + 2), base)), range);
        if (*range.low > *range.high)
            throw UsageError(fmt::format("'{}': the first end is greater than the last", text));
    }
    if (two_sided && (*range.low > 0 || *range.high < 0))
        throw UsageError(fmt::format("'{}': the range must contain 1, the scene as it is", text));
    if (range.change == Change::distance && (*range.high < 0 || range.low.value_or(0) < 0))
        throw UsageError(
            fmt::format("'{}': the camera can only be moved away, by a factor of 1 or more", text));
    return range;
}

}  // namespace lancer::cli
