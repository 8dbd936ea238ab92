#include "parser/transforms.h"

#include <cmath>
#include <limits>

#include "parser/rules.h"

namespace lancer {
namespace {

using Extended = Vec3<long double>;

/// The rotation about an axis of unit length. About the z axis it turns x towards y, and so on
/// cyclically.
Transform turn(const Extended& axis, double degrees) {
    const auto [sine, cosine] = elementary::sine_cosine_of_degrees(degrees);
    const long double s = sine;
    const long double c = cosine;
    // 1 - c without cancellation for small angles: s² / (1 + c).
    const long double rest = c > 0 ? s * s / (1 + c) : 1 - c;
    Transform m;
    m.rows[0] = {axis.x * axis.x * rest + c, axis.x * axis.y * rest - axis.z * s,
                 axis.x * axis.z * rest + axis.y * s};
    m.rows[1] = {axis.y * axis.x * rest + axis.z * s, axis.y * axis.y * rest + c,
                 axis.y * axis.z * rest - axis.x * s};
    m.rows[2] = {axis.z * axis.x * rest - axis.y * s, axis.z * axis.y * rest + axis.x * s,
                 axis.z * axis.z * rest + c};
    return m;
}

/// The rotation about a coordinate axis: elements that are 0 or 1 stay exact.
Transform turn_about(int axis, double degrees) {
    const auto [s, c] = elementary::sine_cosine_of_degrees(degrees);
    const long double sine = s;
    const long double cosine = c;
    Transform m;
    if (axis == 0) {
        m.rows[1] = {0.0L, cosine, -sine};
        m.rows[2] = {0.0L, sine, cosine};
    } else if (axis == 1) {
        m.rows[0] = {cosine, 0.0L, sine};
        m.rows[2] = {-sine, 0.0L, cosine};
    } else {
        m.rows[0] = {cosine, -sine, 0.0L};
        m.rows[1] = {sine, cosine, 0.0L};
    }
    return m;
}

bool read_turn(int axis, const Value& value, TransformList& out) {
    if (!value.is_number()) return false;
    out.append(turn_about(axis, value.number()));
    return true;
}

}  // namespace

void TransformList::append(const Transform& next) {
    map = given ? compose(next, map) : next;
    given = true;
}

bool is_singular(const Transform& m) {
    const Extended& a = m.rows[0];
    const Extended& b = m.rows[1];
    const Extended& c = m.rows[2];
    const long double permanent = std::abs(a.x) * (std::abs(b.y * c.z) + std::abs(b.z * c.y)) +
                                  std::abs(a.y) * (std::abs(b.z * c.x) + std::abs(b.x * c.z)) +
                                  std::abs(a.z) * (std::abs(b.x * c.y) + std::abs(b.y * c.x));
    constexpr long double rounding = 4 * std::numeric_limits<double>::epsilon();
    return !(std::abs(determinant(m)) > rounding * permanent);
}

bool round_transform(const Transform& exact, Affine<double>& rounded) {
    rounded = convert<double>(exact);
    for (const Vec3d& row : rounded.rows)
        if (!is_finite(row)) return false;
    return is_finite(rounded.shift) && !is_singular(convert<long double>(rounded));
}

namespace transform_rules {

bool Translate::read(const Value& value, TransformList& out, std::string&) {
    Vec3d shift;
    if (!rules::read_vector(value, shift)) return false;
    Transform m;
    m.shift = convert<long double>(shift);
    out.append(m);
    return true;
}

bool Scale::read(const Value& value, TransformList& out, std::string&) {
    Vec3d scale;
    if (value.is_number()) {
        scale = Vec3d(value.number());
    } else if (!rules::read_vector(value, scale)) {
        return false;
    }
    if (scale.x == 0 || scale.y == 0 || scale.z == 0) return false;
    Transform m;
    m.rows[0].x = scale.x;
    m.rows[1].y = scale.y;
    m.rows[2].z = scale.z;
    out.append(m);
    return true;
}

bool RotateX::read(const Value& value, TransformList& out, std::string&) {
    return read_turn(0, value, out);
}
bool RotateY::read(const Value& value, TransformList& out, std::string&) {
    return read_turn(1, value, out);
}
bool RotateZ::read(const Value& value, TransformList& out, std::string&) {
    return read_turn(2, value, out);
}

bool Rotate::read(const Value& value, TransformList& out, std::string&) {
    Vec3d axis;
    if (!value.is_list() || value.size() != 2 || !rules::read_vector(value.at(0), axis) ||
        !value.at(1).is_number() || axis == Vec3d(0, 0, 0))
        return false;
    out.append(turn(normalize(convert<long double>(axis)), value.at(1).number()));
    return true;
}

bool Matrix::read(const Value& value, TransformList& out, std::string& instead) {
    if (!value.is_list() || value.size() != 3) return false;
    Transform m;
    for (std::size_t i = 0; i < 3; ++i) {
        const Value row = value.at(i);
        if (!row.is_list() || row.size() != 4) return false;
        double numbers[4];
        for (std::size_t j = 0; j < 4; ++j) {
            if (!row.at(j).is_number()) return false;
            numbers[j] = row.at(j).number();
        }
        m.rows[i] = {numbers[0], numbers[1], numbers[2]};
        if (i == 0) m.shift.x = numbers[3];
        if (i == 1) m.shift.y = numbers[3];
        if (i == 2) m.shift.z = numbers[3];
    }
    if (is_singular(m)) {
        instead = "a singular matrix";
        return false;
    }
    out.append(m);
    return true;
}

}  // namespace transform_rules

}  // namespace lancer
