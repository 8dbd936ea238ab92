// Lathe, prism and patch as POV-Ray's own; B-splines are converted to the equivalent Bézier curves.
#include <fmt/format.h>

#include <algorithm>

#include "reference/pov/choices.h"
#include "reference/pov/shapes.h"

namespace lancer::reference::pov {

namespace {

using Segment = std::array<Vec2d, 4>;  // of a cubic Bezier curve

/// Converts four neighbouring points of a uniform cubic B-spline; de Boor, "A Practical Guide to
/// Splines", X.
template <class Point>
std::array<Point, 4> bezier_of_bspline(const Point& a, const Point& b, const Point& c,
                                       const Point& d) {
    return {(a + 4.0 * b + c) / 6.0, (2.0 * b + c) / 3.0, (b + 2.0 * c) / 3.0,
            (b + 4.0 * c + d) / 6.0};
}

/// From b to c with the tangents (c - a) / 2 and (d - b) / 2.
Segment bezier_of_catmull_rom(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
    return {b, b + (c - a) / 6.0, c - (d - b) / 6.0, c};
}

/// Returns `count` segments. For a closed curve, point(i) is also called beyond the end.
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

/// The same curve in twice as many pieces with the same parameterization, by de Casteljau's
/// subdivision.
std::vector<Segment> halved(const std::vector<Segment>& curve) {
    std::vector<Segment> out;
    for (const Segment& s : curve) {
        const Vec2d ab = (s[0] + s[1]) / 2.0;
        const Vec2d bc = (s[1] + s[2]) / 2.0;
        const Vec2d cd = (s[2] + s[3]) / 2.0;
        const Vec2d abc = (ab + bc) / 2.0;
        const Vec2d bcd = (bc + cd) / 2.0;
        const Vec2d middle = (abc + bcd) / 2.0;
        out.push_back({s[0], ab, abc, middle});
        out.push_back({middle, bcd, cd, s[3]});
    }
    return out;
}

/// POV-Ray solves an equation of the sixth degree for each piece of a lathe, and is more accurate
/// for shorter pieces: docs/export.md, "Curved lathes".
std::vector<Segment> cut_for_lathe(std::vector<Segment> curve) {
    const std::size_t enough = lathe_pieces * curve.size();
    while (curve.size() < enough) curve = halved(curve);
    return curve;
}

void write_points(Text& text, const std::string& head, const std::vector<Vec2d>& points) {
    text.open(head);
    std::vector<std::string> items;
    for (const Vec2d& p : points) items.push_back(vector(p));
    text.list(items);
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
    if (lathe.spline == Spline::linear) {
        spline = "linear_spline";
        for (const Vec2d& q : p) points.push_back(own(q));
    } else {
        const bool bezier = lathe.spline == Spline::bezier;
        const auto curve = segments(lathe.spline, bezier ? (p.size() - 1) / 3 : p.size() - 3,
                                    [&](std::size_t i) { return p[i]; });
        points = flattened(cut_for_lathe(curve), own);
    }
    write_points(writer.text, fmt::format("lathe {{ {} {},", spline, points.size()), points);
    return true;
}

bool open_prism(Writer& writer, const Prism& prism, PowerOfTen own) {
    const std::vector<Vec2d>& p = prism.outline;
    std::vector<Vec2d> points;
    const auto point = [&](std::size_t i) { return p[i % p.size()]; };
    const bool linear = prism.spline == Spline::linear;
    if (linear) {
        for (const Vec2d& q : p) points.push_back(own(q));
        points.push_back(points.front());  // POV-Ray requires a closed outline
    } else {
        const std::size_t count = prism.spline == Spline::bezier ? p.size() / 3 : p.size();
        points = flattened(segments(prism.spline, count, point), own);
    }
    write_points(writer.text,
                 fmt::format("prism {{ {} {}, {}, {},", linear ? "linear_spline" : "bezier_spline",
                             number(own(prism.bottom)), number(own(prism.top)), points.size()),
                 points);
    if (!prism.capped) writer.text.line("open");
    return true;
}

namespace {

using Net = std::array<std::array<Vec3d, 4>, 4>;  // of a bicubic Bezier patch, row by row

/// The Bézier patch of the 4 x 4 control points that begin at (row, column).
Net bezier_net(const Patch& patch, std::size_t row, std::size_t column, PowerOfTen own) {
    Net net;
    for (std::size_t i = 0; i < net.size(); ++i)
        for (std::size_t j = 0; j < net[i].size(); ++j)
            net[i][j] = own(patch.control[(row + i) * patch.columns + column + j]);
    if (patch.basis == Patch::Basis::bezier) return net;
    for (auto& r : net) r = bezier_of_bspline(r[0], r[1], r[2], r[3]);
    for (std::size_t j = 0; j < net.size(); ++j) {
        const auto c = bezier_of_bspline(net[0][j], net[1][j], net[2][j], net[3][j]);
        for (std::size_t i = 0; i < net.size(); ++i) net[i][j] = c[i];
    }
    return net;
}

/// Each block of 4 x 4 points of a net makes a patch.
std::size_t patches_along(std::uint32_t points) {
    return points - 3;
}

int halvings(const Scene& scene) {
    std::vector<std::size_t> patches;
    for (const Object& object : scene.objects)
        if (const auto* shape = std::get_if<PatchRef>(&object.shape)) {
            const Patch& p = scene.patches[shape->patch];
            patches.push_back(patches_along(p.rows) * patches_along(p.columns));
        }
    return halvings_for(patches);
}

std::string uv_corners(const Patch& patch, std::size_t row, std::size_t column) {
    const auto part = [](std::size_t i, std::uint32_t count) {
        return static_cast<double>(i) / static_cast<double>(patches_along(count));
    };
    const double u0 = part(column, patch.columns), u1 = part(column + 1, patch.columns);
    const double v0 = part(row, patch.rows), v1 = part(row + 1, patch.rows);
    return "uv_vectors " + vector(Vec2d(u0, v0)) + ", " + vector(Vec2d(u1, v0)) + ", " +
           vector(Vec2d(u1, v1)) + ", " + vector(Vec2d(u0, v1));
}

void open_bezier(Text& text, const Net& net, int steps, const std::string& uvs) {
    text.open(fmt::format("bicubic_patch {{ type {0} flatness 0 u_steps {1} v_steps {1}",
                          kept_triangles, steps));
    text.line(uvs);
    std::vector<std::string> items;
    for (const auto& row : net)
        for (const Vec3d& p : row) items.push_back(vector(p));
    text.list(items);
}

}  // namespace

bool open_patch(Writer& writer, const Object& object, const Patch& patch, PowerOfTen own) {
    std::vector<Net> nets;
    const std::size_t across = patches_along(patch.columns);
    for (std::size_t i = 0; i < patches_along(patch.rows); ++i)
        for (std::size_t j = 0; j < across; ++j) nets.push_back(bezier_net(patch, i, j, own));
    const int steps = halvings(writer.scene);
    writer.result.patch_halvings[std::get<PatchRef>(object.shape).patch] = steps;
    writer.approximate(
        object.place,
        fmt::format("patch as {0} x {0} x 2 triangles per bicubic patch", std::size_t(1) << steps));
    const bool union_of_patches = patch.basis == Patch::Basis::bspline;
    if (union_of_patches) writer.text.open("union {");
    for (std::size_t k = 0; k < nets.size(); ++k) {
        open_bezier(writer.text, nets[k], steps, uv_corners(patch, k / across, k % across));
        if (union_of_patches) writer.text.close();
    }
    return true;
}

}  // namespace lancer::reference::pov
