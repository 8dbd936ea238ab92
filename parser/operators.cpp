#include "parser/operators.h"

#include <cmath>
#include <cstdlib>

#include "model/elementary.h"

namespace lancer {
namespace {

using ast::Op;

std::string_view symbol_of(Op op) {
    switch (op) {
        case Op::negate:
        case Op::subtract:
            return "-";
        case Op::invert:
            return "!";
        case Op::add:
            return "+";
        case Op::multiply:
            return "*";
        case Op::divide:
            return "/";
        case Op::modulo:
            return "%";
        case Op::power:
            return "^";
        case Op::less:
            return "<";
        case Op::less_equal:
            return "<=";
        case Op::greater:
            return ">";
        case Op::greater_equal:
            return ">=";
        case Op::equal:
            return "==";
        case Op::not_equal:
            return "!=";
        default:
            return "?";
    }
}

/// The remainder of a / b, with the sign of b.
double modulo(double a, double b) {
    const double r = std::fmod(a, b);
    if (r == 0) return std::copysign(0.0, b);
    return (r < 0) != (b < 0) ? r + b : r;
}

/// The result for one component. Reports an error and sets `wrong` when there is none.
double arithmetic(Op op, double a, double b, const Site& site, bool& wrong) {
    if (wrong) return 0;
    switch (op) {
        case Op::add:
            return a + b;
        case Op::subtract:
            return a - b;
        case Op::multiply:
            return a * b;
        default:
            break;
    }
    if (op == Op::power) {
        if (a < 0 && b != std::floor(b)) {
            site.report.error(Message::power_domain, site.place, to_text(a), to_text(b));
            wrong = true;
            return 0;
        }
        if (a != 0 || b >= 0) return power(a, b);
    } else if (b != 0) {
        return op == Op::divide ? a / b : modulo(a, b);
    }
    site.report.error(Message::division_by_zero, site.place);
    wrong = true;
    return 0;
}

bool is_arithmetic(const Value& v) {
    return v.is_number() || v.is(Value::Kind::vector);
}

Value apply_arithmetic(Op op, const Value& a, const Value& b, const Site& site) {
    bool wrong = false;
    Value result;
    if (a.is_number() && b.is_number()) {
        result = Value(arithmetic(op, a.number(), b.number(), site, wrong));
    } else {
        const unsigned size = a.is_number() ? b.dimension() : a.dimension();
        if (!a.is_number() && !b.is_number() && a.dimension() != b.dimension()) {
            site.report.error(Message::vector_sizes, site.place, symbol_of(op), a.dimension(),
                              b.dimension());
            return {};
        }
        double c[3] = {0, 0, 0};
        for (unsigned i = 0; i < size; ++i)
            c[i] = arithmetic(op, a.is_number() ? a.number() : a.component(i),
                              b.is_number() ? b.number() : b.component(i), site, wrong);
        result = size == 2 ? Value(c[0], c[1]) : Value(c[0], c[1], c[2]);
    }
    if (wrong) return {};
    if (!is_finite_value(result)) {
        site.report.error(Message::not_finite, site.place);
        return {};
    }
    return result;
}

/// A number and its rounding error (a double-word).
struct Pair {
    double high = 1;
    double low = 0;
};

Pair multiply(const Pair& a, const Pair& b) {
    const double high = a.high * b.high;
    const double low = std::fma(a.high, b.high, -high) + (a.high * b.low + a.low * b.high);
    const double sum = high + low;
    return {sum, low - (sum - high)};
}

}  // namespace

double power(double x, double y) {
    constexpr double most = 1 << 20;
    if (y != std::floor(y) || std::abs(y) > most) return elementary::pow(x, y);
    Pair result;
    Pair square{x, 0};
    for (auto n = static_cast<std::uint32_t>(std::abs(y)); n != 0; n >>= 1) {
        if (n & 1) result = multiply(result, square);
        if (n > 1) square = multiply(square, square);
    }
    // If the pair overflowed or underflowed on the way, the library's function gives the result.
    const double whole = result.high + result.low;
    const double value = y < 0 ? 1 / whole : whole;
    const bool in_range =
        std::isfinite(whole) && std::abs(whole) > 1e-290 && std::abs(whole) < 1e290;
    return in_range || y == 0 ? value : elementary::pow(x, y);
}

bool is_finite_value(const Value& v) {
    if (v.is_number()) return std::isfinite(v.number());
    if (!v.is(Value::Kind::vector)) return true;
    for (unsigned i = 0; i < v.dimension(); ++i)
        if (!std::isfinite(v.component(i))) return false;
    return true;
}

bool equal_values(const Value& a, const Value& b, const Site& site) {
    if (a.is_list() && b.is_list()) {
        if (a.size() != b.size()) return false;
        // A list can be far longer than the work that made it, because parts are shared: so
        // comparisons count like elements made.
        site.meter.elements(a.size(), site.place);
        for (std::uint64_t i = 0; i < a.size(); ++i)
            if (!equal_values(a.at(i), b.at(i), site)) return false;
        return true;
    }
    if (a.kind() != b.kind()) return false;
    switch (a.kind()) {
        case Value::Kind::number:
            return a.number() == b.number();
        case Value::Kind::text:
            return a.text() == b.text();
        case Value::Kind::boolean:
            return a.boolean() == b.boolean();
        default:
            return a.index() == b.index();
    }
}

Value apply_binary(Op op, const Value& a, const Value& b, const Site& site) {
    if (a.is_broken() || b.is_broken()) return {};
    switch (op) {
        case Op::equal:
        case Op::not_equal: {
            const auto comparable = [](const Value& v) {
                return !v.is(Value::Kind::material) && !v.is(Value::Kind::texture);
            };
            if (!comparable(a) || !comparable(b)) break;
            return Value(equal_values(a, b, site) == (op == Op::equal));
        }
        case Op::less:
        case Op::less_equal:
        case Op::greater:
        case Op::greater_equal: {
            if (!a.is_number() || !b.is_number()) break;
            const double x = a.number();
            const double y = b.number();
            return Value(op == Op::less         ? x < y
                         : op == Op::less_equal ? x <= y
                         : op == Op::greater    ? x > y
                                                : x >= y);
        }
        default:
            if (is_arithmetic(a) && is_arithmetic(b)) return apply_arithmetic(op, a, b, site);
            if (op == Op::add && a.is(Value::Kind::text) && b.is(Value::Kind::text)) {
                site.meter.text(a.text().size() + b.text().size(), site.place);
                std::string joined(a.text());
                joined += b.text();
                return Value(std::move(joined));
            }
            break;
    }
    Diagnostic* error = site.report.error(Message::operator_operands, site.place, symbol_of(op),
                                          kind_name(a), kind_name(b));
    const bool text = a.is(Value::Kind::text) || b.is(Value::Kind::text);
    if (error != nullptr && op == Op::add && text)
        error->hint = "use str(x) to make a string of a value";
    return {};
}

Value apply_unary(Op op, const Value& a, const Site& site) {
    if (a.is_broken()) return {};
    if (op == Op::negate && is_arithmetic(a)) return map_components(a, [](double x) { return -x; });
    if (op == Op::invert && a.is(Value::Kind::boolean)) return Value(!a.boolean());
    site.report.error(Message::operator_operand, site.place, symbol_of(op), kind_name(a));
    return {};
}

std::uint64_t size_of(const Value& value) {
    return value.is(Value::Kind::text) ? value.characters() : value.size();
}

std::string size_text(const Value& value) {
    const std::uint64_t count = size_of(value);
    const bool text = value.is(Value::Kind::text);
    return std::to_string(count) + (text ? " character" : " element") + (count == 1 ? "" : "s");
}

Value characters_of(const Value& text, std::uint64_t from, std::uint64_t count, const Site& site) {
    const std::string_view all = text.text();
    std::size_t begin = from;
    std::size_t end = from + count;
    if (text.characters() != all.size()) {
        // Characters have different lengths in bytes, so the search begins at the start; this
        // counts as reading.
        site.meter.elements(from + count, site.place);
        const auto after = [&](std::size_t at, std::uint64_t steps) {
            for (; steps > 0; --steps) do
                    ++at;
                while (at < all.size() && (static_cast<unsigned char>(all[at]) & 0xC0) == 0x80);
            return at;
        };
        begin = after(0, from);
        end = after(begin, count);
    }
    site.meter.text(end - begin, site.place);
    return Value(std::string(all.substr(begin, end - begin)));
}

Value element_at(const Value& list, const Value& index, const Site& site) {
    if (list.is_broken() || index.is_broken()) return {};
    const bool text = list.is(Value::Kind::text);
    if (!text && !list.is_list()) {
        site.report.error(Message::not_a_list, site.place, kind_name(list));
        return {};
    }
    if (!index.is_number() || index.number() != std::floor(index.number())) {
        site.report.error(Message::index_type, site.place, describe(index));
        return {};
    }
    if (index.number() < 0 || index.number() >= static_cast<double>(size_of(list))) {
        site.report.error(Message::index_range, site.place, to_text(index.number()),
                          text ? "string" : "list", size_text(list));
        return {};
    }
    const auto at = static_cast<std::uint64_t>(index.number());
    return text ? characters_of(list, at, 1, site) : list.at(at);
}

Value component_of(const Value& vector, unsigned component, const Site& site) {
    if (vector.is_broken()) return {};
    if (vector.is(Value::Kind::vector) && component < vector.dimension())
        return Value(vector.component(component));
    site.report.error(Message::no_member, site.place, kind_name(vector), "xyz"[component]);
    return {};
}

}  // namespace lancer
