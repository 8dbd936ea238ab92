// Light at extremes: grazing, near, strong, sharp.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/extremes/picture.h"

namespace lancer::extremes {
namespace {

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

}  // namespace
}  // namespace lancer::extremes
