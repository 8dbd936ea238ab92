#include "reference/pov/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <span>

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
    // POV-Ray multiplies a row vector from the left, so its rows are our columns.
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

std::string identifier(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        out += letter || (c >= '0' && c <= '9') ? c : '_';
    }
    return out;
}

double PowerOfTen::operator()(double length) const {
    if (!std::isfinite(length)) return length;
    // Writes the shortest digits in scientific form, "1.2e-03", and reads them back with another
    // exponent.
    std::array<char, 40> text{};
    char* const end =
        std::to_chars(text.data(), text.data() + text.size(), length, std::chars_format::scientific)
            .ptr;
    char* const power = std::find(text.data(), end, 'e') + 1;
    int decades{};
    std::from_chars(*power == '+' ? std::next(power) : power, end, decades);
    char* const new_end = std::to_chars(power, text.data() + text.size(), decades + exponent).ptr;
    double moved{};
    const auto read = std::from_chars(text.data(), new_end, moved);
    // Out of range: the product gives the infinity or zero.
    return read.ec == std::errc{} ? moved : length * factor();
}

Vec3d PowerOfTen::plainly(const Vec3d& v) const {
    // Divides instead of multiplying by a fraction: powers up to 10^22 are exact.
    const double power = PowerOfTen{std::abs(exponent)}.factor();
    return exponent > 0 ? v * power : v / power;
}

void Text::list(const std::vector<std::string>& items) {
    constexpr std::size_t per_line = 4;
    for (std::span rest(items); !rest.empty();) {
        const auto row = rest.first(std::min(per_line, rest.size()));
        rest = rest.subspan(row.size());
        line(fmt::format("{}{}", fmt::join(row, ", "), rest.empty() ? "" : ","));
    }
}

void Text::line(std::string_view text) {
    out_.append(static_cast<std::size_t>(depth_) * 4, ' ');
    out_.append(text);
    out_ += '\n';
}

}  // namespace lancer::reference::pov
