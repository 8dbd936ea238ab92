#include "parser/vector_functions.h"

#include <algorithm>
#include <cmath>

#include "model/math.h"

namespace lancer {
namespace {

Value takes_vectors(std::string_view name, std::string_view what, const Value& given,
                    const Site& site) {
    site.report.error(Message::function_argument, site.place, name, what, kind_name(given));
    return {};
}

/// Largest absolute component, as a power of two, so that squares neither over- nor underflow.
double scale_of(const Value& v) {
    double most = 0;
    for (unsigned i = 0; i < v.dimension(); ++i) most = std::max(most, std::abs(v.component(i)));
    return most == 0 ? 1 : std::ldexp(1.0, std::ilogb(most));
}

double length_of(const Value& v, double scale) {
    double sum = 0;
    for (unsigned i = 0; i < v.dimension(); ++i) {
        const double x = v.component(i) / scale;
        sum += x * x;
    }
    return std::sqrt(sum);
}

}  // namespace

Value vector_length(std::string_view name, std::span<const Value> a, const Site& site) {
    if (!a[0].is(Value::Kind::vector)) return takes_vectors(name, "a vector", a[0], site);
    const double scale = scale_of(a[0]);
    return Value(length_of(a[0], scale) * scale);
}

Value normalize_vector(std::string_view name, std::span<const Value> a, const Site& site) {
    if (!a[0].is(Value::Kind::vector)) return takes_vectors(name, "a vector", a[0], site);
    const double scale = scale_of(a[0]);
    const double size = length_of(a[0], scale);
    if (size == 0) {
        site.report.error(Message::function_domain, site.place, name, "a vector of length 0");
        return {};
    }
    return map_components(a[0], [&](double x) { return x / scale / size; });
}

Value dot_product(std::string_view name, std::span<const Value> a, const Site& site) {
    for (const Value& v : a)
        if (!v.is(Value::Kind::vector)) return takes_vectors(name, "vectors", v, site);
    const Value products = apply_binary(ast::Op::multiply, a[0], a[1], site);
    if (products.is_broken()) return {};
    double sum = 0;
    for (unsigned i = 0; i < products.dimension(); ++i) sum += products.component(i);
    return Value(sum);
}

Value cross_product(std::string_view name, std::span<const Value> a, const Site& site) {
    for (const Value& v : a)
        if (!v.is_vector(3)) return takes_vectors(name, "vectors of 3 numbers", v, site);
    const auto vec = [](const Value& v) {
        return Vec3d(v.component(0), v.component(1), v.component(2));
    };
    const Vec3d c = cross(vec(a[0]), vec(a[1]));
    return {c.x, c.y, c.z};
}

}  // namespace lancer
