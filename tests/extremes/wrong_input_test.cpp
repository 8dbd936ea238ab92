// Numbers at the limits of the range: a right picture or an error, never NaN and never an endless
// loop.
#include <gtest/gtest.h>

#include "model/diagnostic.h"
#include "tests/extremes/picture.h"

namespace lancer::extremes {
namespace {

/// Renders if compile lets it; picture() checks that every value is finite.
void picture_or_error(const Scene& scene, const char* what) {
    SCOPED_TRACE(what);
    for (const Precision p : {Precision::single, Precision::double_, Precision::extended}) {
        try {
            picture(scene, p);
        } catch (const SceneError& error) {
            EXPECT_STRNE(error.what(), "");
        }
    }
}

TEST(WrongInput, CoordinatesAtTheEndOfTheRange) {
    for (const double x : {1e150, 1e300, 1.7e308}) {
        for (int i = 0; i < 8; ++i) {
            Stage s = base_stage();
            const std::uint32_t m = s.matt({1, 0, 0});
            switch (i) {
                case 0:
                    s.add(Sphere{{x, 0, 0}, 1}, m);
                    break;
                case 1:
                    s.add(Sphere{{0, 0, 0}, x}, m);
                    break;
                case 2:
                    s.add(Box{{-x, -1, -x}, {x, 0, x}}, s.glass(1.5));
                    break;
                case 3:
                    s.add(Cylinder{{0, -x, 0}, {0, x, 0}, 1}, m);
                    break;
                case 4:
                    s.add(Cone{{0, 0, 0}, {0, x, 0}, x, 0}, m);
                    break;
                case 5:
                    s.add(Plane{{0, 1, 0}, -x}, m);
                    break;
                case 6:
                    s.add(Triangle{{Vec3d(-x, 0, 0), Vec3d(x, 0, 0), Vec3d(0, x, x)}}, m);
                    break;
                default:
                    s.add(cube(Vec3d(-x), Vec3d(x)), m);
                    break;
            }
            picture_or_error(s.scene, ("large " + std::to_string(i)).c_str());
        }
        Stage s = base_stage();
        s.look({x, x, x}, {0, 0, 0}, 40);
        picture_or_error(s.scene, "camera far away");
        s = base_stage();
        s.lamp({x, -x, x});
        picture_or_error(s.scene, "lamp far away");
        picture_or_error(scaled(base_stage().scene, x / 10), "scaled");
        picture_or_error(under(base_stage().scene, stretched(x, 1, 1)), "stretched");
    }
}

TEST(WrongInput, NumbersNextToZero) {
    for (const double r : {1e-150, 1e-300, 1e-320, 5e-324}) {
        for (int i = 0; i < 6; ++i) {
            Stage s = base_stage();
            const std::uint32_t m = s.matt({1, 0, 0});
            switch (i) {
                case 0:
                    s.add(Sphere{{0, 0, 0}, r}, m);
                    break;
                case 1:
                    s.add(Box{{0, 0, 0}, Vec3d(r)}, s.glass(1.5));
                    break;
                case 2:
                    s.add(Cylinder{{0, 0, 0}, {0, 1, 0}, r}, m);
                    break;
                case 3:
                    s.add(Cylinder{{0, 0, 0}, {0, r, 0}, 1}, m);
                    break;
                case 4:
                    s.add(Cone{{0, 0, 0}, {0, r, 0}, r, 0}, m);
                    break;
                default:
                    s.add(Triangle{{Vec3d(0, 0, 0), Vec3d(r, 0, 0), Vec3d(0, r, r)}}, m);
                    break;
            }
            picture_or_error(s.scene, ("small " + std::to_string(i)).c_str());
        }
        picture_or_error(scaled(base_stage().scene, r), "scaled");
        picture_or_error(under(base_stage().scene, stretched(r, 1, 1)), "flattened");
        picture_or_error(under(base_stage().scene, stretched(r, r, r)), "scaled under a group");
        Stage s;
        s.add(Sphere{{0, 0, 0}, r}, s.matt({1, 0, 0}));
        s.look({0, 0, 4 * r}, {0, 0, 0}, 40);
        s.lamp({r, r, 4 * r});
        picture_or_error(s.scene, "a scene of its own");
    }
}

/// Light that overflows is an error, not a picture with NaN.
TEST(WrongInput, LightBeyondAllNumbers) {
    for (const double x : {1e30, 1e100, 1e200, 1.7e308}) {
        Stage s = base_stage();
        s.lamp({1, 9, 1}, Color(x));
        for (Material& m : s.scene.materials) {
            m.color *= x;
            m.phong = x;
            if (m.filter == 0) m.reflection = Color(x);
        }
        picture_or_error(s.scene, "bright");
        s.scene.background = Color(x);
        s.scene.ambient = Color(x);
        for (Material& m : s.scene.materials) m.emission = m.absorption = Color(x);
        picture_or_error(s.scene, "bright everywhere");
    }
    Stage s = base_stage();
    s.lamp({1, 9, 1}, Color(1e308));
    s.scene.materials[1].color = Color(1e308);
    EXPECT_THROW(picture(s.scene), SceneError);
}

}  // namespace
}  // namespace lancer::extremes
