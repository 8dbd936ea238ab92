#include "parser/functions.h"

#include <bit>
#include <cmath>
#include <limits>

#include "model/math.h"
#include "model/srgb.h"
#include "parser/css_colors.h"
#include "parser/list_functions.h"
#include "parser/random.h"
#include "parser/suggest.h"
#include "parser/vector_functions.h"

namespace lancer {
namespace {

using Arguments = std::span<const Value>;
constexpr std::size_t any_count = std::numeric_limits<std::size_t>::max();

Value takes(std::string_view name, std::string_view what, const Value& given, const Site& site) {
    site.report.error(Message::function_argument, site.place, name, what, kind_name(given));
    return {};
}

Value outside(std::string_view name, double x, const Site& site) {
    site.report.error(Message::function_domain, site.place, name, to_text(x));
    return {};
}

bool is_arithmetic(const Value& v) {
    return v.is_number() || v.is(Value::Kind::vector);
}

bool everywhere(double) {
    return true;
}
bool from_minus_one_to_one(double x) {
    return x >= -1 && x <= 1;
}
bool not_negative(double x) {
    return x >= 0;
}
bool positive(double x) {
    return x > 0;
}

double square_root(double x) {
    return std::sqrt(x);
}
double absolute(double x) {
    return std::abs(x);
}
double floor_of(double x) {
    return std::floor(x);
}
double ceiling_of(double x) {
    return std::ceil(x);
}
double rounded(double x) {
    return std::round(x);
}
double sign_of(double x) {
    return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0;
}
double to_radians(double x) {
    return radians(x);
}
double to_degrees(double x) {
    return degrees(x);
}

/// A function of one number.
template <double (*f)(double), bool (*domain)(double) = everywhere>
Value of_number(std::string_view name, Arguments a, const Site& site) {
    if (!a[0].is_number()) return takes(name, "a number", a[0], site);
    if (!domain(a[0].number())) return outside(name, a[0].number(), site);
    return Value(f(a[0].number()));
}

/// A function of one number, or of each component of a vector.
template <double (*f)(double)>
Value of_components(std::string_view name, Arguments a, const Site& site) {
    if (!is_arithmetic(a[0])) return takes(name, "numbers or vectors", a[0], site);
    return map_components(a[0], f);
}

double lesser(double a, double b) {
    return b < a ? b : a;
}
double greater(double a, double b) {
    return a < b ? b : a;
}

/// Two numbers, two vectors, or a vector and a number: component by component.
template <class F>
Value combine(std::string_view name, const Value& a, const Value& b, const Site& site, F f) {
    if (!is_arithmetic(a)) return takes(name, "numbers or vectors", a, site);
    if (!is_arithmetic(b)) return takes(name, "numbers or vectors", b, site);
    if (a.is_number() && b.is_number()) return Value(f(a.number(), b.number()));
    if (!a.is_number() && !b.is_number() && a.dimension() != b.dimension()) {
        site.report.error(Message::vector_sizes, site.place, name, a.dimension(), b.dimension());
        return {};
    }
    const unsigned size = a.is_number() ? b.dimension() : a.dimension();
    double c[3] = {0, 0, 0};
    for (unsigned i = 0; i < size; ++i)
        c[i] = f(a.is_number() ? a.number() : a.component(i),
                 b.is_number() ? b.number() : b.component(i));
    return size == 2 ? Value(c[0], c[1]) : Value(c[0], c[1], c[2]);
}

template <double (*f)(double, double)>
Value fold(std::string_view name, Arguments a, const Site& site) {
    Value result = a[0];
    if (!is_arithmetic(result)) return takes(name, "numbers or vectors", result, site);
    for (std::size_t i = 1; i < a.size() && !result.is_broken(); ++i)
        result = combine(name, result, a[i], site, f);
    return result;
}

Value clamp(std::string_view name, Arguments a, const Site& site) {
    const Value above = combine(name, a[0], a[1], site, greater);
    return above.is_broken() ? above : combine(name, above, a[2], site, lesser);
}

/// a (1 - t) + b t: exactly a at t = 0 and exactly b at t = 1.
Value mix(std::string_view name, Arguments a, const Site& site) {
    const auto product = [](double x, double y) { return x * y; };
    const Value rest =
        combine(name, a[2], Value(1.0), site, [](double t, double) { return 1 - t; });
    if (rest.is_broken()) return {};
    const Value left = combine(name, a[0], rest, site, product);
    if (left.is_broken()) return {};
    const Value right = combine(name, a[1], a[2], site, product);
    if (right.is_broken()) return {};
    return combine(name, left, right, site, [](double x, double y) { return x + y; });
}

Value atan2_of(std::string_view name, Arguments a, const Site& site) {
    for (const Value& v : a)
        if (!v.is_number()) return takes(name, "numbers", v, site);
    return Value(elementary::atan2(a[0].number(), a[1].number()));
}

Value pow_of(std::string_view name, Arguments a, const Site& site) {
    for (const Value& v : a)
        if (!v.is_number()) return takes(name, "numbers", v, site);
    return apply_binary(ast::Op::power, a[0], a[1], site);
}

Value len(std::string_view name, Arguments a, const Site& site) {
    if (a[0].is_list()) return Value(static_cast<double>(a[0].size()));
    if (a[0].is(Value::Kind::text)) return Value(static_cast<double>(a[0].characters()));
    return takes(name, "a list or a string", a[0], site);
}

Value srgb(std::string_view name, Arguments a, const Site& site) {
    double c[3];
    for (std::size_t i = 0; i < 3; ++i) {
        if (!a[i].is_number()) return takes(name, "numbers", a[i], site);
        if (a[i].number() < 0) return outside(name, a[i].number(), site);
        c[i] = srgb_decode(a[i].number());
    }
    return {c[0], c[1], c[2]};
}

Value css(std::string_view name, Arguments a, const Site& site) {
    if (!a[0].is(Value::Kind::text)) return takes(name, "a string", a[0], site);
    std::string wanted(a[0].text());
    for (char& c : wanted)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (const CssColor* color = css_color(wanted)) {
        const Vec3d light = srgb_color(color->srgb);
        return {light.x, light.y, light.z};
    }
    Diagnostic* error =
        site.report.error(Message::css_unknown, site.place, std::string(a[0].text()));
    if (error != nullptr) {
        Suggestion suggestion(wanted);
        for (const CssColor& color : css_colors()) suggestion.consider(color.name);
        error->hint = suggestion.hint();
    }
    return {};
}

Value rand(std::string_view name, Arguments a, const Site& site) {
    RandomHash hash;
    for (const Value& v : a) {
        if (v.is_number()) {
            hash.add(v.number());
        } else if (v.is(Value::Kind::vector)) {
            for (unsigned i = 0; i < v.dimension(); ++i) hash.add(v.component(i));
        } else {
            return takes(name, "numbers or vectors", v, site);
        }
    }
    return Value(hash.fraction());
}

Value str(std::string_view, Arguments a, const Site& site) {
    std::string text = to_text(a[0], site.meter.text_left());
    site.meter.text(text.size(), site.place);
    return Value(std::move(text));
}

Value range(std::string_view name, Arguments a, const Site& site) {
    for (const Value& v : a)
        if (!v.is_number()) return takes(name, "numbers", v, site);
    const double start = a[0].number();
    const double end = a[1].number();
    const double step = a.size() > 2 ? a[2].number() : 1;
    if (step == 0) {
        site.report.error(Message::range_step_zero, site.place);
        return {};
    }
    const auto before_end = [&](double i) {
        return step > 0 ? start + i * step < end : start + i * step > end;
    };
    // Rounding may make the quotient wrong by one: check its neighbours against the definition.
    double count = std::ceil((end - start) / step);
    if (!(count < static_cast<double>(std::numeric_limits<std::uint32_t>::max())) &&
        before_end(0)) {
        site.meter.elements(std::numeric_limits<std::uint64_t>::max(), site.place);
        return {};
    }
    count = greater(count, 0);
    site.meter.elements(static_cast<std::uint64_t>(count), site.place);
    while (count > 0 && !before_end(count - 1)) --count;
    while (before_end(count)) ++count;
    return Value::of_range(start, step, static_cast<std::uint64_t>(count));
}

constexpr Function functions[] = {
    {"sin", 1, 1, "x", "x is an angle in radians", of_number<elementary::sin>},
    {"cos", 1, 1, "x", "x is an angle in radians", of_number<elementary::cos>},
    {"tan", 1, 1, "x", "x is an angle in radians", of_number<elementary::tan>},
    {"asin", 1, 1, "x", "the angle in radians; x from -1 to 1",
     of_number<elementary::asin, from_minus_one_to_one>},
    {"acos", 1, 1, "x", "the angle in radians; x from -1 to 1",
     of_number<elementary::acos, from_minus_one_to_one>},
    {"atan", 1, 1, "x", "the angle in radians", of_number<elementary::atan>},
    {"atan2", 2, 2, "y, x", "the angle of [x, y] with the x axis, in radians", atan2_of},
    {"sqrt", 1, 1, "x", "square root, x of 0 or more", of_number<square_root, not_negative>},
    {"exp", 1, 1, "x", "e to the power of x", of_number<elementary::exp>},
    {"log", 1, 1, "x", "natural logarithm, x greater than 0", of_number<elementary::log, positive>},
    {"pow", 2, 2, "x, y", "the same as x ^ y", pow_of},
    {"abs", 1, 1, "x", "absolute value; also of vectors", of_components<absolute>},
    {"sign", 1, 1, "x", "-1, 0 or 1; also of vectors", of_components<sign_of>},
    {"floor", 1, 1, "x", "the largest whole number that is not above x; also of vectors",
     of_components<floor_of>},
    {"ceil", 1, 1, "x", "the smallest whole number that is not below x; also of vectors",
     of_components<ceiling_of>},
    {"round", 1, 1, "x",
     "the nearest whole number, halves are rounded away from zero; also of vectors",
     of_components<rounded>},
    {"min", 2, any_count, "a, b, ...", "the smallest; of vectors component by component",
     fold<lesser>},
    {"max", 2, any_count, "a, b, ...", "the largest; of vectors component by component",
     fold<greater>},
    {"clamp", 3, 3, "x, low, high", "x, limited to the range from low to high; also of vectors",
     clamp},
    {"mix", 3, 3, "a, b, t", "a (1 - t) + b t; also of vectors", mix},
    {"radians", 1, 1, "x", "degrees to radians", of_number<to_radians>},
    {"degrees", 1, 1, "x", "radians to degrees", of_number<to_degrees>},
    {"length", 1, 1, "v", "the length of a vector", vector_length},
    {"normalize", 1, 1, "v", "the vector of length 1 in the same direction", normalize_vector},
    {"dot", 2, 2, "a, b", "scalar product", dot_product},
    {"cross", 2, 2, "a, b", "vector product", cross_product},
    {"len", 1, 1, "x", "the number of elements of a list, or of characters of a string", len},
    {"srgb", 3, 3, "r, g, b", "a colour given in sRGB, 0 to 1, as linear RGB", srgb},
    {"css", 1, 1, "name", "one of the 148 CSS colours by its name, as \"tomato\", as linear RGB",
     css},
    {"rand", 1, any_count, "a, ...", "a number in [0, 1) that depends only on the arguments", rand},
    {"str", 1, 1, "x", "a value as a string", str},
    {"range", 2, 3, "a, b, step",
     "the list a, a + step, a + 2 step, ... that ends before b; step is 1 by default", range},
    {"concat", 1, any_count, "a, ...", "the elements of all these lists in one", concat_lists},
    {"reverse", 1, 1, "list", "the elements from the last to the first", reverse_list},
    {"slice", 2, 3, "x, from, to",
     "the part of a list or string from index `from` up to, but without, index `to`; to is len(x) "
     "by default",
     slice},
    {"last", 1, 1, "x", "the last element of a list, or character of a string", last_element},
    {"sum", 1, 1, "list",
     "the sum of numbers, or of vectors component by component; rounding errors are compensated",
     sum_list},
};

constexpr Constant constants[] = {
    {"pi", pi, "half a turn in radians"},
    {"tau", tau, "a whole turn in radians"},
};

}  // namespace

std::string arguments_text(std::size_t least, std::size_t most) {
    std::string text = std::to_string(least);
    if (most > least + 1) {
        text += " or more";
    } else if (most > least) {
        text += " or " + std::to_string(most);
    }
    return text + (text == "1" ? " argument" : " arguments");
}

std::span<const Function> all_functions() {
    return functions;
}
std::span<const Constant> all_constants() {
    return constants;
}

}  // namespace lancer
