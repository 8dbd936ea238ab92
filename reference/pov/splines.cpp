// Lathe, prism and patch: POV-Ray's own, with B-splines turned into the Bezier curves that they
// are.
#include <fmt/format.h>

#include <algorithm>

#include "reference/pov/shapes.h"

namespace lancer::reference::pov {

namespace {

using Segment = std::array<Vec2d, 4>;  // of a cubic Bezier curve

/// Four neighbours of a uniform cubic B-spline; de Boor, "A Practical Guide to Splines", X.
Segment bezier_of_bspline(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
    return {(a + 4.0 * b + c) / 6.0, (2.0 * b + c) / 3.0, (b + 2.0 * c) / 3.0,
            (b + 4.0 * c + d) / 6.0};
}

/// From b to c with the tangents (c - a) / 2 and (d - b) / 2.
Segment bezier_of_catmull_rom(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
    return {b, b + (c - a) / 6.0, c - (d - b) / 6.0, c};
}

/// `count` segments; point(i) may be asked for beyond the end by a closed curve.
template <class Point>
std::vector<Segment> segments(Spline spline, std::size_t count, const Point& point) {
    std::vector<Segment> out;
    for (std::size_t i = 0; i < count; ++i) {
        if (spline == Spline::bezier)
            out.push_back({point(3 * i), point(3 * i + 1), point(3 * i + 2), point(3 * i + 3)});
        else if (spline == Spline::bspline)
            out.push_back(bezier_of_bspline(point(i), point(i + 1), point(i + 2), point(i + 3)));
        else
            out.push_back(
                bezier_of_catmull_rom(point(i), point(i + 1), point(i + 2), point(i + 3)));
    }
    return out;
}

void write_points(Text& text, const std::string& head, const std::vector<Vec2d>& points,
                  std::size_t per_line) {
    text.open(head);
    for (std::size_t i = 0; i < points.size(); i += per_line) {
        std::string line;
        for (std::size_t j = i; j < std::min(i + per_line, points.size()); ++j)
            line += (j > i ? " " : "") + vector(points[j]) + (j + 1 < points.size() ? "," : "");
        text.line(line);
    }
}

std::vector<Vec2d> flattened(const std::vector<Segment>& curve, PowerOfTen own) {
    std::vector<Vec2d> out;
    for (const Segment& segment : curve)
        for (const Vec2d& p : segment) out.push_back(own(p));
    return out;
}

}  // namespace

bool open_lathe(Writer& writer, const Lathe& lathe, PowerOfTen own) {
    const std::vector<Vec2d>& p = lathe.profile;
    std::vector<Vec2d> points;
    std::string spline = "bezier_spline";
    const auto point = [&](std::size_t i) { return p[i]; };
    switch (lathe.spline) {
        case Spline::linear:
        case Spline::catmull_rom:
            spline = lathe.spline == Spline::linear ? "linear_spline" : "cubic_spline";
            for (const Vec2d& q : p) points.push_back(own(q));
            break;
        case Spline::bezier:
            points = flattened(segments(lathe.spline, (p.size() - 1) / 3, point), own);
            break;
        case Spline::bspline:
            points = flattened(segments(lathe.spline, p.size() - 3, point), own);
            break;
    }
    write_points(writer.text, fmt::format("lathe {{ {} {},", spline, points.size()), points, 4);
    return true;
}

bool open_prism(Writer& writer, const Prism& prism, PowerOfTen own) {
    const std::vector<Vec2d>& p = prism.outline;
    std::vector<Vec2d> points;
    const auto point = [&](std::size_t i) { return p[i % p.size()]; };
    const bool linear = prism.spline == Spline::linear;
    if (linear) {
        for (const Vec2d& q : p) points.push_back(own(q));
        points.push_back(points.front());  // POV-Ray wants the outline closed
    } else {
        const std::size_t count = prism.spline == Spline::bezier ? p.size() / 3 : p.size();
        points = flattened(segments(prism.spline, count, point), own);
    }
    write_points(writer.text,
                 fmt::format("prism {{ {} {}, {}, {},", linear ? "linear_spline" : "bezier_spline",
                             number(own(prism.bottom)), number(own(prism.top)), points.size()),
                 points, 4);
    if (!prism.capped) writer.text.line("open");
    return true;
}

bool open_patch(Writer& writer, const Object& object, const Patch&, PowerOfTen) {
    writer.refuse(object.place, "patches are not exported yet");
    return false;
}

}  // namespace lancer::reference::pov
