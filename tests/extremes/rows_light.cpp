#include <cmath>

#include "tests/extremes/rows.h"
#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

Material pure_diffuse() {
    Material m;
    m.ambient = 0;
    m.diffuse = 1;
    return m;
}

Scene grazing(const std::string& shape, int k) {
    Stage s;
    const std::uint32_t m = s.material(pure_diffuse());
    if (shape == "plane") s.add(Plane{{0, 1, 0}, 0}, m);
    if (shape == "box") s.add(Box{{-9, -1, -9}, {9, 0, 9}}, m);
    if (shape == "cylinder's cap") s.add(Cylinder{{0, -1, 0}, {0, 0, 0}, 9}, m);
    if (shape == "triangle")
        s.add(Triangle{{Vec3d(-30, 0, -30), Vec3d(30, 0, -30), Vec3d(0, 0, 40)}}, m);
    const double e = power10(-k);
    s.sun({1, -e, 0}, Color(0.5 / e * std::sqrt(1 + e * e)));
    s.look({0.1, 3, 2}, {0, 0, 0}, 30);
    return s.scene;
}

constexpr int strip_width = 16;
constexpr int strip_height = 64;

/// The strip of the terminator 10^-k wide, lit by 10^k, seen from the side.
Scene terminator(bool ball, int k) {
    Stage s;
    const double e = power10(-k);
    const std::uint32_t m = s.material(pure_diffuse());
    if (ball)
        s.add(Sphere{{0, 0, 0}, 1}, m);
    else
        s.add(Cylinder{{0, 0, -5}, {0, 0, 5}, 1}, m);
    s.sun({0, -1, 0}, Color(1 / e));
    s.scene.width = strip_width;
    s.scene.height = strip_height;
    s.look_parallel({3, 0, 0}, {0, 0, 0}, 2 * e);
    return s.scene;
}

/// N·L over the strip is linear.
Image terminator_light(int) {
    Image image(strip_width, strip_height);
    for (int y = 0; y < strip_height; ++y)
        for (int x = 0; x < strip_width; ++x)
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = std::max(0.0, 1 - (y + 0.5) / (strip_height / 2.0));
    return image;
}

constexpr int highlight_side = 33;
double highlight_half_angle(double n) {
    return std::min(20.0, degrees(2 / std::sqrt(n)));
}

/// The mirror image of the sun is the camera itself.
Scene highlight(bool phong, int k) {
    const double n = power10(k);
    Stage s;
    Material m;
    m.ambient = 0;
    m.diffuse = 0;
    m.color = {0, 0, 0};
    (phong ? m.phong : m.blinn) = 1;
    m.shininess = n;
    m.roughness = 1 / n;
    s.add(Plane{{0, 0, 1}, 0}, s.material(m));
    s.sun({0, 0, -1});
    s.scene.width = s.scene.height = highlight_side;
    s.look({0, 0, 2}, {0, 0, 0}, 2 * highlight_half_angle(n));
    return s.scene;
}

/// cos^n of the angle from the axis (Phong) or of half of it (Blinn).
Image highlight_light(bool phong, int k) {
    const double n = power10(k);
    const double edge = std::tan(radians(highlight_half_angle(n)));
    Image image(highlight_side, highlight_side);
    for (int y = 0; y < highlight_side; ++y) {
        for (int x = 0; x < highlight_side; ++x) {
            const double px = (x - 16) / 16.5 * edge;
            const double py = (y - 16) / 16.5 * edge;
            const double t = std::tan(std::atan(std::hypot(px, py)) / (phong ? 1 : 2));
            // log cos a = -1/2 log(1 + tan^2 a), exact near 0.
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = std::exp(-n / 2 * std::log1p(t * t));
        }
    }
    return image;
}

Scene strong_light(int k) {
    Stage s = base_stage();
    for (Material& m : s.scene.materials) {
        if (m.filter == 0 && m.reflection.x == 0) m.color *= power10(-k);
        if (m.reflection.x > 0) m.diffuse = 0;  // mirror and glass show only the other objects
    }
    for (Light& light : s.scene.lights) light.color *= power10(k);
    s.scene.ambient *= power10(k);
    return s.scene;
}

/// A lamp close to a plane, with the camera at a proportional distance: all heights give one
/// picture.
Scene near_lamp(int k) {
    const double h = power10(-k);
    Stage s;
    s.add(Plane{{0, 1, 0}, 0}, s.material(pure_diffuse()));
    s.lamp({0, h, 0});
    s.look({0, 8 * h, 0.5 * h}, {0, 0, 0}, 40, {0, 0, 1});
    s.add(Sphere{{0, 1e3, 0}, 1}, s.matt({1, 1, 1}));  // keeps the scene large
    return s.scene;
}

Stage striped() {
    Stage s;
    s.look({0.4, 2, 5}, {0, 0.5, 0}, 40);
    s.lamp({3, 5, 2});
    s.scene.background = {0.1, 0.2, 0.4};
    s.scene.settings.max_depth = 250;
    s.add(Plane{{0, 1, 0}, -0.5}, s.matt({0.8, 0.8, 0.9}));
    s.add(Box{{-2, -0.5, -2}, {-0.3, 2, -1.5}}, s.matt({0.9, 0.2, 0.1}));
    return s;
}

Scene shells(int count, bool alternating) {
    Stage s = striped();
    for (int i = 0; i < count; ++i)
        s.add(Sphere{{0, 0.5, 0}, 0.9 - 0.8 * i / count},
              s.glass(alternating && i % 2 == 1 ? 1.0 : 1.5));
    return s.scene;
}

Scene almost_air(int k) {
    Stage s = striped();
    s.add(Sphere{{0, 0.5, 0}, 0.9}, s.glass(1 + power10(-k)));
    return s.scene;
}

Scene clear_things(int) {
    Stage s = striped();
    const std::uint32_t clear = s.glass(1);
    s.add(Sphere{{0, 0.5, 0}, 0.9}, clear);
    s.add(Box{{-0.2, 0, 0.3}, {1.5, 1.3, 1}}, clear);
    s.add(Cylinder{{-1, 0, 0}, {-1, 1, 0.5}, 0.4}, clear);
    s.add(icosphere({1, 0.2, 1}, 0.4, 1), clear);
    return s.scene;
}

}  // namespace

std::vector<Row> rows_of_light() {
    std::vector<Row> rows;
    Row row;
    for (const char* shape : {"plane", "box", "cylinder's cap", "triangle"}) {
        row = {};
        row.name = std::string("light 10⁻ᵏ above a ") + shape;
        row.ks = ks_from(1, 16);
        row.scene = [shape](int k) { return grazing(shape, k); };
        row.uniform = Color(0.5, 0.5, 0.5);
        row.allowed = none_wrong(1, 15);
        row.asked = "0, k ≤ 15";
        row.tachyon = std::string(shape) == "plane" || std::string(shape) == "triangle";
        row.plotted = std::string(shape) == "plane";
        rows.push_back(row);
    }
    for (const bool ball : {true, false}) {
        row = {};
        row.name = std::string("terminator of a ") + (ball ? "ball" : "cylinder") + ", 10⁻ᵏ wide";
        row.ks = ks_from(1, 16);
        row.scene = [ball](int k) { return terminator(ball, k); };
        row.formula = terminator_light;
        row.allowed = none_wrong(1, 15);
        row.asked = "0, k ≤ 15";
        rows.push_back(row);
    }
    for (const bool phong : {true, false}) {
        row = {};
        row.name = phong ? "Phong highlight, exponent 10ᵏ" : "Blinn highlight, roughness 10⁻ᵏ";
        row.ks = ks_from(0, phong ? 8 : 9);
        row.scene = [phong](int k) { return highlight(phong, k); };
        row.formula = [phong](int k) { return highlight_light(phong, k); };
        row.allowed = none_wrong(0, 9);
        row.asked = phong ? "k ≤ 8" : "k ≤ 9";
        rows.push_back(row);
    }
    row = {};
    row.name = "light times 10ᵏ on paint times 10⁻ᵏ";
    row.ks = ks_from(-39, 39, 3);
    row.scene = strong_light;
    row.same_as = [](int) { return strong_light(0); };
    row.allowed = none_wrong(-30, 30);
    row.asked = "0, \\|k\\| ≤ 30";
    row.tachyon = true;
    rows.push_back(row);

    row = {};
    row.name = "lamp at height 10⁻ᵏ over a plane";
    row.ks = ks_from(1, 17);
    row.scene = near_lamp;
    row.same_as = [](int) { return near_lamp(0); };
    row.allowed = none_wrong(1, 16);
    row.asked = "0, k ≤ 16";
    row.tachyon = true;
    rows.push_back(row);

    row = {};
    row.name = "things of index 1, against none: pixels with another bit";
    row.ks = {0};
    row.scene = clear_things;
    row.same_as = [](int) { return striped().scene; };
    row.bits = true;
    row.allowed = none_wrong(0, 0);
    row.asked = "0";
    rows.push_back(row);

    row = {};
    row.name = "ball of index 1 + 10⁻ᵏ";
    row.ks = ks_from(1, 16);
    row.scene = row.exactly_as = almost_air;
    row.allowed = none_wrong(1, 16);
    row.asked = "0";
    rows.push_back(row);

    row = {};
    row.name = "k equal glass shells, against one";
    row.ks = {2, 10, 50, 100};
    row.scene = [](int k) { return shells(k, false); };
    row.exactly_as = [](int) { return shells(1, false); };
    row.steady = true;
    row.allowed = none_wrong(2, 100);
    row.asked = "0, k ≤ 100";
    rows.push_back(row);

    row = {};
    row.name = "k shells of glass and air in turn";
    row.ks = {2, 10, 25, 50};
    row.scene = row.exactly_as = [](int k) { return shells(k, true); };
    row.allowed = none_wrong(2, 50);
    row.asked = "0, k ≤ 50";
    rows.push_back(row);
    return rows;
}

}  // namespace lancer::extremes
