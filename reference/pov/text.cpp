#include "reference/pov/text.h"

#include <fmt/format.h>

namespace lancer::reference::pov {

std::string number(double value) {
    return value == 0.0 ? "0" : fmt::format("{}", value);  // no "-0"
}

std::string mesh_number(double value) {
    return value == 0.0 ? "0" : fmt::format("{:.9g}", value);
}

std::string vector(const Vec2d& v) {
    return "<" + number(v.x) + ", " + number(v.y) + ">";
}

std::string vector(const Vec3d& v) {
    return "<" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ">";
}

std::string mesh_vector(const Vec2d& v) {
    return "<" + mesh_number(v.x) + "," + mesh_number(v.y) + ">";
}

std::string mesh_vector(const Vec3d& v) {
    return "<" + mesh_number(v.x) + "," + mesh_number(v.y) + "," + mesh_number(v.z) + ">";
}

std::string rgb(const Color& color) {
    if (color.x == color.y && color.y == color.z) return "rgb " + number(color.x);
    return "rgb " + vector(color);
}

std::string transform(const Affine<double>& map) {
    const Affine<double> identity;
    if (map == identity) return "";
    if (map.rows == identity.rows) return "translate " + vector(map.shift);
    // POV-Ray multiplies a row vector from the left: its rows are our columns.
    return fmt::format("matrix <{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}>",
                       number(map.rows[0].x), number(map.rows[1].x), number(map.rows[2].x),
                       number(map.rows[0].y), number(map.rows[1].y), number(map.rows[2].y),
                       number(map.rows[0].z), number(map.rows[1].z), number(map.rows[2].z),
                       number(map.shift.x), number(map.shift.y), number(map.shift.z));
}

std::string comment(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        out += byte < 0x20 || byte == 0x7F ? ' ' : c;
    }
    return out;
}

std::string identifier(std::string_view text, std::size_t longest) {
    std::string out;
    for (const char c : text.substr(0, longest)) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        out += letter || (c >= '0' && c <= '9') ? c : '_';
    }
    return out;
}

double PowerOfTen::operator()(double length) const {
    // One rounding: multiplied by 10^n or divided by it, both exact up to 10^22.
    double power = 1;
    for (int i = exponent < 0 ? -exponent : exponent; i > 0; --i) power *= 10;
    return exponent < 0 ? length / power : length * power;
}

void Text::line(std::string_view text) {
    out_.append(static_cast<std::size_t>(depth_) * 4, ' ');
    out_.append(text);
    out_ += '\n';
}

}  // namespace lancer::reference::pov
