// Light at extremes: grazing, near, strong, sharp.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

Material pure_diffuse() {
    Material m;
    m.ambient = 0;
    m.diffuse = 1;
    return m;
}

TEST(Light, Grazing) {
    for (const char* kind : {"plane", "box", "triangle", "cap"}) {
        for (int k = 1; k <= 15; ++k) {
            Stage s;
            const std::uint32_t m = s.material(pure_diffuse());
            const std::string name = kind;
            if (name == "plane") s.add(Plane{{0, 1, 0}, 0}, m);
            if (name == "box") s.add(Box{{-9, -1, -9}, {9, 0, 9}}, m);
            if (name == "cap") s.add(Cylinder{{0, -1, 0}, {0, 0, 0}, 9}, m);
            if (name == "triangle")
                s.add(Triangle{{Vec3d(-30, 0, -30), Vec3d(30, 0, -30), Vec3d(0, 0, 40)}}, m);
            const double e = power10(-k);
            s.sun({1, -e, 0}, Color(0.5 / e * std::sqrt(1 + e * e)));
            s.look({0.1, 3, 2}, {0, 0, 0}, 30);
            EXPECT_EQ(wrong(picture(s.scene), Color(0.5, 0.5, 0.5)), 0) << kind << " " << k;
        }
    }
}

/// The strip of the terminator of width 10^-k, light 10^k: N.L over the strip is linear.
TEST(Light, Terminator) {
    for (const bool ball : {true, false}) {
        for (int k = 1; k <= 14; ++k) {
            Stage s;
            const double e = power10(-k);
            const std::uint32_t m = s.material(pure_diffuse());
            if (ball)
                s.add(Sphere{{0, 0, 0}, 1}, m);
            else
                s.add(Cylinder{{0, 0, -5}, {0, 0, 5}, 1}, m);
            s.sun({0, -1, 0}, Color(1 / e));
            // Looking along -x at (1, 0, 0), the strip y in (-e, e).
            s.scene.width = 16;
            s.scene.height = 64;
            s.look_parallel({3, 0, 0}, {0, 0, 0}, 2 * e);
            const Image image = picture(s.scene);
            int bad = 0;
            for (int y = 0; y < 64; ++y) {
                const double height = 1 - (y + 0.5) / 32;  // in units of e
                for (int x = 0; x < 16; ++x)
                    bad += std::abs(std::min(1.0, image.pixel(x, y)[0]) - std::max(0.0, height)) >
                           1.0 / 255;
            }
            EXPECT_EQ(bad, 0) << (ball ? "sphere " : "cylinder ") << k;
        }
    }
}

TEST(Light, HighlightsOfAnySharpness) {
    for (const bool phong : {true, false}) {
        for (int k = 0; k <= (phong ? 8 : 9); ++k) {
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
            // The mirror image of the sun is the camera itself. Angle a from the axis: the
            // highlight is cos^n of a (Phong, the mirrored ray against the light) or of a/2
            // (Blinn).
            const double half = std::min(20.0, degrees(2 / std::sqrt(n)));
            s.scene.width = s.scene.height = 33;
            s.look({0, 0, 2}, {0, 0, 0}, 2 * half);
            const Image image = picture(s.scene);
            double most = 0;
            for (int y = 0; y < 33; ++y) {
                for (int x = 0; x < 33; ++x) {
                    const double px = (x - 16) / 16.5 * std::tan(radians(half));
                    const double py = (y - 16) / 16.5 * std::tan(radians(half));
                    const double tangent = std::hypot(px, py);
                    const double a = std::atan(tangent) / (phong ? 1 : 2);
                    // log cos a = -1/2 log(1 + tan^2 a), exact near 0.
                    const double t = std::tan(a);
                    const double expected = std::exp(-n / 2 * std::log1p(t * t));
                    most = std::max(most, std::abs(image.pixel(x, y)[0] - expected));
                }
            }
            EXPECT_LE(most, 1e-4) << (phong ? "phong " : "blinn ") << n;
            EXPECT_NEAR(image.pixel(16, 16)[0], 1, 1e-4) << n;
        }
    }
}

TEST(Light, StrongLightOnDarkPaint) {
    Stage plain = base_stage();
    const auto with = [&](int k) {
        Stage s = base_stage();
        for (Material& m : s.scene.materials) {
            if (m.filter == 0 && m.reflection.x == 0) m.color *= power10(-k);
        }
        for (Light& light : s.scene.lights) light.color *= power10(k);
        s.scene.ambient *= power10(k);
        // Mirror and glass show only the others.
        for (Material& m : s.scene.materials) {
            if (m.reflection.x > 0) m.diffuse = 0;
        }
        return s.scene;
    };
    const Image reference = picture(with(0));
    for (int k = -39; k <= 39; k += 3) EXPECT_EQ(wrong(picture(with(k)), reference), 0) << k;
}

TEST(Light, CloseToAPlane) {
    // A lamp at height h over a plane, seen from as near: all heights give one picture.
    const auto scene = [](double h) {
        Stage s;
        s.add(Plane{{0, 1, 0}, 0}, s.material(pure_diffuse()));
        s.lamp({0, h, 0});
        s.look({0, 8 * h, 0.5 * h}, {0, 0, 0}, 40, {0, 0, 1});
        s.add(Sphere{{0, 1e3, 0}, 1}, 0);  // keeps the scene large
        return s.scene;
    };
    const Image reference = picture(scene(1));
    for (int k = 1; k <= 16; ++k) EXPECT_EQ(wrong(picture(scene(power10(-k))), reference), 0) << k;
}

}  // namespace
}  // namespace lancer::extremes
