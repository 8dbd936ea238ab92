#include "parser/list_functions.h"

#include <cmath>
#include <string>

namespace lancer {
namespace {

Value takes(std::string_view name, std::string_view what, const std::string& given,
            const Site& site) {
    site.report.error(Message::function_argument, site.place, name, what, given);
    return {};
}

/// Reserves room for `count` elements and counts them against the limits.
std::vector<Value> room_for(std::uint64_t count, const Site& site) {
    site.meter.elements(count, site.place);
    site.meter.held(Value::held_bytes() + count * sizeof(Value), site.place);
    std::vector<Value> room;
    room.reserve(count);
    return room;
}

/// A sum and its accumulated rounding error.
struct Sum {
    double value = 0, lost = 0;

    void add(double x) {
        const double next = value + x;
        lost += std::abs(value) >= std::abs(x) ? (value - next) + x : (x - next) + value;
        value = next;
    }
    double total() const { return value + lost; }
};

}  // namespace

Value concat_lists(std::string_view name, std::span<const Value> a, const Site& site) {
    std::uint64_t count = 0;
    for (const Value& list : a) {
        if (!list.is_list()) return takes(name, "lists", kind_name(list), site);
        count += list.size();
    }
    std::vector<Value> all = room_for(count, site);
    for (const Value& list : a)
        for (std::uint64_t i = 0; i < list.size(); ++i) all.push_back(list.at(i));
    return Value(std::move(all));
}

Value reverse_list(std::string_view name, std::span<const Value> a, const Site& site) {
    if (!a[0].is_list()) return takes(name, "a list", kind_name(a[0]), site);
    std::vector<Value> all = room_for(a[0].size(), site);
    for (std::uint64_t i = a[0].size(); i-- > 0;) all.push_back(a[0].at(i));
    return Value(std::move(all));
}

Value slice(std::string_view name, std::span<const Value> a, const Site& site) {
    const bool text = a[0].is(Value::Kind::text);
    if (!text && !a[0].is_list()) return takes(name, "a list or a string", kind_name(a[0]), site);
    const auto size = static_cast<double>(size_of(a[0]));
    double bounds[] = {0, size};
    for (std::size_t i = 1; i < a.size(); ++i) {
        if (!a[i].is_number() || a[i].number() != std::floor(a[i].number())) {
            site.report.error(Message::index_type, site.place, describe(a[i]));
            return {};
        }
        bounds[i - 1] = a[i].number();
    }
    if (!(bounds[0] >= 0 && bounds[0] <= bounds[1] && bounds[1] <= size)) {
        site.report.error(Message::slice_range, site.place, to_text(bounds[0]), to_text(bounds[1]),
                          text ? "string" : "list", size_text(a[0]));
        return {};
    }
    const auto from = static_cast<std::uint64_t>(bounds[0]);
    const auto to = static_cast<std::uint64_t>(bounds[1]);
    if (text) return characters_of(a[0], from, to - from, site);
    std::vector<Value> some = room_for(to - from, site);
    for (std::uint64_t i = from; i < to; ++i) some.push_back(a[0].at(i));
    return Value(std::move(some));
}

Value last_element(std::string_view name, std::span<const Value> a, const Site& site) {
    const bool text = a[0].is(Value::Kind::text);
    if (!text && !a[0].is_list()) return takes(name, "a list or a string", kind_name(a[0]), site);
    const std::uint64_t count = size_of(a[0]);
    if (count == 0) {
        site.report.error(Message::function_domain, site.place, name,
                          text ? "an empty string" : "an empty list");
        return {};
    }
    return text ? characters_of(a[0], count - 1, 1, site) : a[0].at(count - 1);
}

Value sum_list(std::string_view name, std::span<const Value> a, const Site& site) {
    constexpr std::string_view what = "a list of numbers, or of vectors of one size";
    if (!a[0].is_list()) return takes(name, what, kind_name(a[0]), site);
    const std::uint64_t count = a[0].size();
    site.meter.elements(count, site.place);
    Sum sums[3];
    Value first;
    for (std::uint64_t i = 0; i < count; ++i) {
        const Value element = a[0].at(i);
        if (i == 0) first = element;
        const bool number = element.is_number();
        const bool fits = number || element.is(Value::Kind::vector);
        if (!fits || element.kind() != first.kind() || element.dimension() != first.dimension())
            return takes(name, what,
                         "one whose element " + std::to_string(i) + " is " + describe(element),
                         site);
        if (number) sums[0].add(element.number());
        for (unsigned c = 0; c < element.dimension(); ++c) sums[c].add(element.component(c));
    }
    if (count == 0 || first.is_number()) return Value(sums[0].total());
    return first.dimension() == 2 ? Value(sums[0].total(), sums[1].total())
                                  : Value(sums[0].total(), sums[1].total(), sums[2].total());
}

}  // namespace lancer
