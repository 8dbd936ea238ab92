#include <cmath>

#include "tests/extremes/rows.h"
#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

Stage lit() {
    Stage s;
    s.scene.background = {0.1, 0.2, 0.4};
    s.sun({-1, -2, -3}, {0.7, 0.7, 0.7});
    s.sun({2, -1, -1}, {0.5, 0.4, 0.3});
    return s;
}

/// A rod of radius r and length 2 l about the origin along `along`, its middle filling the picture.
Scene rod(const Vec3d& along, double r, double l, bool cone) {
    Stage s = lit();
    const std::uint32_t m = s.matt({0.9, 0.8, 0.7});
    if (cone)
        s.add(Cone{-along * l, along * l, r, r / 2}, m);
    else
        s.add(Cylinder{-along * l, along * l, r}, m);
    const Vec3d aside = normalize(cross(along, Vec3d(0.3, -0.2, 1)));
    const Vec3d from = normalize(cross(aside, along) + 0.4 * aside);
    s.look(from * (4 * r), Vec3d(0.0), 45, along);
    return s.scene;
}

/// A cone whose apex is 2·10^k away.
Scene almost_cylinder(int k) {
    Stage s = lit();
    const Vec3d along = normalize(Vec3d(1, 2, -0.7));
    s.add(Cone{-along, along, 1, 1 - power10(-k)}, s.matt({0.9, 0.8, 0.7}));
    s.look({1.5, 2, 4}, {0, 0, 0}, 45);
    return s.scene;
}

/// A cone's apex is alike at every zoom.
Scene apex(double angle, int k) {
    Stage s = lit();
    const Affine<double> map = compose(turn(0, angle), turn(1, angle));
    s.add(Cone{map_point(map, {0, -1, 0}), {0, 0, 0}, 0.75, 0}, s.matt({0.9, 0.8, 0.7}));
    s.look(map_point(map, Vec3d(0.3, 0.3, 0.7) * power10(-k) * 3.0), {0, 0, 0}, 30,
           map_vector(map, {0, 0, 1}));
    return s.scene;
}

/// Black inside a white world: every white pixel is a leak.
Stage dark() {
    Stage s;
    s.scene.background = {1, 1, 1};
    s.scene.ambient = {0, 0, 0};
    return s;
}
std::uint32_t black(Stage& s) {
    Material m;
    m.ambient = 0;
    m.diffuse = 0;
    m.color = {0, 0, 0};
    return s.material(m);
}
Vec3d perpendicular(const Vec3d& v) {
    return normalize(cross(v, std::abs(v.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0)));
}

Scene zoomed_on(bool loose, bool edge, int k) {
    static const Mesh ball = icosphere({0.1, -0.2, 0.3}, 1, 1);
    const Mesh::Corners& f = ball.faces[static_cast<std::size_t>(7 + 5 * k) % ball.faces.size()];
    const Vec3d at = edge ? (ball.vertices[f[0]] + ball.vertices[f[1]]) / 2.0 : ball.vertices[f[0]];
    const Vec3d out = normalize(at - Vec3d(0.1, -0.2, 0.3));
    Stage s = dark();
    // Odd, so that one ray aims at the very vertex.
    s.scene.width = 129;
    s.scene.height = 97;
    const std::uint32_t m = black(s);
    if (loose) {
        for (const Mesh::Corners& g : ball.faces)
            s.add(Triangle{{ball.vertices[g[0]], ball.vertices[g[1]], ball.vertices[g[2]]}}, m);
    } else {
        s.add(ball, m);
    }
    s.look(at + out * 4.0 + perpendicular(out) * 0.7, at,
           degrees(2 * std::atan(0.5 * power10(-k) / 8)), perpendicular(out));
    return s.scene;
}

/// The middle of a closed octahedron stretched 1 : 10^k, its edges across the picture.
Scene octahedron(int k) {
    const Affine<double> map =
        compose(turn(1, 20), compose(turn(2, 33), stretched(1, power10(k), 1)));
    Mesh mesh;
    for (const Vec3d& v : {Vec3d(1, 0, 0), Vec3d(-1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, -1, 0),
                           Vec3d(0, 0, 1), Vec3d(0, 0, -1)})
        mesh.vertices.push_back(map_point(map, v));
    mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    Stage s = dark();
    s.add(mesh, black(s));
    const Affine<double> turned = compose(turn(1, 20), turn(2, 33));
    s.look_parallel(map_vector(turned, {1.5, 0, 5}), {0, 0, 0}, 0.4, map_vector(turned, {0, 1, 0}));
    return s.scene;
}

/// One triangle of height 10^-k, its long sides filling the picture.
Scene needle(double angle, int k) {
    const Affine<double> map = compose(turn(2, angle), stretched(1, power10(-k), 1));
    Stage s = dark();
    s.add(Triangle{{map_point(map, {-1, -0.3, 0}), map_point(map, {1.1, -0.2, 0}),
                    map_point(map, {0.05, 0.5, 0})}},
          black(s));
    s.look_parallel(map_point(map, {0.01, 0.1, 3}), map_point(map, {0.01, 0.1, 0}),
                    1.5 * power10(-k), map_vector(turn(2, angle), {0, 1, 0}));
    return s.scene;
}

/// Two solids that share a face, zoomed onto the seam.
Scene seam(bool boxes, int k) {
    Stage s = dark();
    const std::uint32_t m = black(s);
    const Vec3d axis = normalize(Vec3d(0.3, 1, 0.2));
    if (boxes) {
        s.add(Box{{-1, -1, -1}, {1, 0, 1}}, m);
        s.add(Box{{-1, 0, -1}, {1, 1, 1}}, m);
    } else {
        s.add(Cylinder{-axis, Vec3d(0.0), 1}, m);
        s.add(Cylinder{Vec3d(0.0), axis, 1}, m);
    }
    s.look({0.1, 0.2, 5}, {0.01, 0, 0}, degrees(2 * std::atan(0.5 * power10(-k) / 10)));
    return s.scene;
}

}  // namespace

std::vector<Row> rows_of_shapes() {
    std::vector<Row> rows;
    Row row;
    const Vec3d upright(0, 1, 0);
    const Vec3d tilted = normalize(Vec3d(1, 2, -0.7));
    for (const bool cone : {false, true}) {
        for (const Vec3d& along : {upright, tilted}) {
            const bool straight = along == upright;
            row = {};
            row.name = std::string(cone ? "cone" : "cylinder") +
                       " of radius 10⁻ᵏ and length 10ᵏ, " + (straight ? "along an axis" : "tilted");
            // A shorter one shows its ends, or its slant.
            row.ks = ks_from(cone ? 4 : 3, straight ? 12 : 8);
            row.scene = [=](int k) { return rod(along, power10(-k), power10(k), cone); };
            if (cone)
                row.exactly_as = [=](int) { return rod(along, 1, 1e6, true); };
            else
                row.same_as = [=](int) { return rod(along, 1, 1e3, false); };
            row.allowed = none_wrong(4, straight ? 10 : 5);
            row.asked = straight ? "0, k ≤ 10" : "0, k ≤ 5";
            row.steady = cone;
            row.tachyon = !cone;
            row.plotted = !cone && straight;
            rows.push_back(row);
        }
    }
    for (const Vec3d& along : {upright, tilted}) {
        row = {};
        row.name = std::string("cylinder of radius 10⁻ᵏ and length 2, ") +
                   (along == upright ? "along an axis" : "tilted");
        row.ks = ks_from(4, 14);
        row.scene = [=](int k) { return rod(along, power10(-k), 1, false); };
        row.same_as = [=](int) { return rod(along, 1e-3, 1, false); };
        row.allowed = none_wrong(4, 12);
        row.asked = "0, k ≤ 12";
        row.tachyon = true;
        rows.push_back(row);
    }
    row = {};
    row.name = "cone of radii 1 and 1 − 10⁻ᵏ";
    row.ks = ks_from(1, 16);
    row.scene = row.exactly_as = almost_cylinder;
    row.allowed = none_wrong(1, 16);
    row.asked = "0, k ≤ 16";
    rows.push_back(row);
    for (const double angle : {0.0, 37.0}) {
        row = {};
        row.name = std::string("a cone's apex, zoom 10ᵏ") + (angle == 0 ? "" : ", turned by 37°");
        row.ks = ks_from(1, 15);
        row.scene = [=](int k) { return apex(angle, k); };
        row.same_as = [=](int) { return apex(angle, 1); };
        row.allowed = none_wrong(1, 14);
        row.asked = "0, k ≤ 14";
        row.plotted = angle != 0;
        rows.push_back(row);
    }
    for (const bool loose : {false, true}) {
        for (const bool edge : {false, true}) {
            row = {};
            row.name = std::string("leaks, zoom 10ᵏ onto ") + (edge ? "an edge" : "a vertex") +
                       " of " + (loose ? "single triangles" : "a mesh");
            row.ks = ks_from(0, 14, 2);
            row.scene = [=](int k) { return zoomed_on(loose, edge, k); };
            row.uniform = Color(0, 0, 0);
            row.allowed = none_wrong(0, 14);
            row.asked = "0, k ≤ 14";
            row.tachyon = true;
            row.plotted = !edge && !loose;
            rows.push_back(row);
        }
    }
    row = {};
    row.name = "leaks of a closed octahedron stretched 1 : 10ᵏ";
    row.ks = ks_from(0, 14);
    row.scene = octahedron;
    row.uniform = Color(0, 0, 0);
    row.allowed = none_wrong(0, 12);
    row.asked = "0, k ≤ 12";
    row.tachyon = true;
    rows.push_back(row);
    for (const double angle : {0.0, 40.0}) {
        row = {};
        row.name = std::string("one triangle 10⁻ᵏ tall") + (angle == 0 ? "" : ", turned by 40°");
        row.ks = ks_from(0, 14);
        row.scene = [=](int k) { return needle(angle, k); };
        row.exactly_as = row.scene;
        row.allowed = none_wrong(0, 12);
        row.asked = "0, k ≤ 12";
        rows.push_back(row);
    }
    for (const bool boxes : {true, false}) {
        row = {};
        row.name =
            std::string("seam of two ") + (boxes ? "boxes" : "tilted cylinders") + ", zoom 10ᵏ";
        row.ks = ks_from(0, 14, 2);
        row.scene = [=](int k) { return seam(boxes, k); };
        row.uniform = Color(0, 0, 0);
        row.allowed = none_wrong(0, 14);
        row.asked = "0, k ≤ 14";
        row.tachyon = true;
        rows.push_back(row);
    }
    return rows;
}

}  // namespace lancer::extremes
