// Measures the rules of POV-Ray that docs/export.md states. If another POV-Ray had another rule,
// the differences that the rule excuses would be errors.
#include <fmt/format.h>

#include <cmath>

#include "tests/reference/pov/povray_fixture.h"
#include "tests/reference/pov/scene_kit.h"

namespace lancer::reference {
namespace {

constexpr double step = 1.0 / 65535;

class Rules : public WithPovRay {
  protected:
    /// The middle pixel of a picture along -z from (0, 0, `from`); the scene's text determines
    /// everything else.
    double seen(double from, const std::string& objects) const {
        const std::string text = fmt::format(
            "#version 3.7;\n"
            "global_settings {{ assumed_gamma 1.0 max_trace_level 20 adc_bailout 0 ambient_light "
            "rgb 1 }}\n"
            "background {{ rgb 0.5 }}\n"
            "camera {{ orthographic location <0, 0, {}> direction <0, 0, -1> right <0.1, 0, 0> up "
            "<0, 0.1, 0> }}\n"
            "#declare Clear = texture {{ pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} }}\n"
            "#declare Mirror = texture {{ pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 "
            "reflection {{ rgb 1 fresnel }} conserve_energy }} }}\n"
            "#declare Glow = texture {{ pigment {{ rgb 1 }} finish {{ ambient 0.5 diffuse 0 }} }}\n"
            "#declare Fade = interior {{ ior 1 fade_power 1001 fade_distance 2 fade_color rgb 0.25 "
            "}}\n{}",
            from, objects);
        return rendered(text, {}, {0, 3, 3}).pixel(1, 1)[0];
    }
};

TEST_F(Rules, AbsorptionIsBeerLambertsForWhatPasses) {
    EXPECT_NEAR(seen(5, "box { -1, 1 texture { Clear } interior { Fade } }"),
                0.5 * std::exp(-0.75 * 2 / 2), step);
}

TEST_F(Rules, AbsorptionInsideLeavesOutTheSurfacesOwnLight) {
    // The camera is inside, and the far wall glows half as strongly as it is opaque.
    const std::string half = "pigment { rgbt <1, 1, 1, 0.5> } finish { ambient 0.4 diffuse 0 }";
    const double fade = std::exp(-0.75 * 1.5 / 2);
    EXPECT_NEAR(seen(0.5, "box { -1, 1 texture { " + half + " } interior { Fade } }"),
                0.5 * 0.4 + 0.5 * 0.5 * fade, step);
}

TEST_F(Rules, AbsorptionNestedIsLeftOutBeforeAnotherObject) {
    EXPECT_NEAR(
        seen(
            5,
            "box { -1, 1 texture { Clear } interior { Fade } } sphere { 0, 0.5 texture { Glow } }"),
        0.5, step);
}

TEST_F(Rules, GlassWithFresnelAndConserveEnergyIsInvisibleInEvenSurroundings) {
    EXPECT_NEAR(seen(5, "sphere { <0.9, 0, 0>, 1 texture { Mirror } interior { ior 1.5 } }"), 0.5,
                1e-4);
}

TEST_F(Rules, FresnelNestedMirrorsNothingOnLeavingTheInnerBody) {
    // Light 1 is behind the camera and light 0 in front, so the visible light is reflected.
    const std::string ends =
        "plane { -z, -9 pigment { rgb 1 } finish { ambient 1 diffuse 0 } }"
        "plane { z, -9 pigment { rgb 0 } finish { ambient 0 diffuse 0 } }"
        "box { -1, 1 texture { Mirror } interior { ior 1.5 } }";
    const auto mirrored = [](double n) { return (n - 1) * (n - 1) / ((n + 1) * (n + 1)); };
    const double air = mirrored(1.5);
    // Two faces alone in air: r + (1 - r)^2 r + … = 2r / (1 + r).
    EXPECT_NEAR(seen(5, ends), 2 * air / (1 + air), step);
    const double water = mirrored(1.5 / 1.33);
    EXPECT_NEAR(seen(5, ends + "box { -7, 7 texture { Clear } interior { ior 1.33 } }"), water,
                step);
}

TEST_F(Rules, ASheetInAMediumBends) {
    // A tilted sheet without an index inside glass: a ray that goes straight on would meet the glow
    // behind.
    const std::string scene =
        "box { -1, 1 texture { Clear } interior { ior 1.5 } }"
        "box { <-0.3, -0.3, -1.9>, <0.3, 0.3, -1.8> texture { Glow } finish { ambient 1 } }";
    const std::string sheet =
        "triangle { <-2, -2, 1.2>, <2, -2, -1.2>, <0, 2, 0> texture { Clear } interior { ior 1 } }";
    EXPECT_NEAR(seen(5, scene), 1, step);
    EXPECT_NEAR(seen(5, scene + sheet), 0.5, step);
}

/// A smooth facet refracts the ray back in front of itself, but at the next face of the mesh it
/// still leaves. A wall shows where it arrives.
TEST_F(Rules, SmoothMeshesCountMediaByTheKindOfRay) {
    const std::string mesh =
        "mesh { smooth_triangle { <-0.1, -2, 1>, <-1, -0.01, 1>, <0.1, 0, -1>, <-1, 0, 1>, <-0.1, "
        "2, 1>, <-1, 0.01, 1> } triangle { <-50, -50, -2>, <50, -50, -2>, <0, 80, -2> } texture { "
        "Clear } interior { ior 1.5 } }";
    const std::string wall =
        "plane { z, -4 pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 8 } finish { "
        "ambient 1 diffuse 0 } }";
    const double incident = std::asin(std::sqrt(0.5));  // to the shading normal
    const double first = std::sin(incident - std::asin(std::sqrt(0.5) / 1.5));
    const auto tangent = [](double sine) { return sine / std::sqrt(1 - sine * sine); };
    const double leaving = 2 * tangent(first) + 2 * tangent(1.5 * first);
    const double entering = 2 * tangent(first) + 2 * tangent(first / 1.5);
    ASSERT_GT(leaving - entering, 0.1);
    EXPECT_NEAR(seen(5, mesh + wall), leaving / 8, step);
}

TEST_F(Rules, ThreeEqualNormalsAreNone) {
    const auto lit = [&](const std::string& third) {
        return seen(
            5,
            "light_source { <0, 0, 100> rgb 1 parallel point_at 0 } mesh2 { vertex_vectors { "
            "3, <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> } normal_vectors { 3, <0.6, 0, 0.8>, <0.6, "
            "0, 0.8>, <0.6, " +
                third +
                ", 0.8> } face_indices { 1, <0, 1, 2> } pigment { rgb 1 } finish { ambient 0 "
                "diffuse 1 } }");
    };
    EXPECT_NEAR(lit("0.001"), 0.8, 1e-5);
    EXPECT_NEAR(lit("0"), 1, step);
}

TEST_F(Rules, GradientsRepeatWithAnotherPeriodBelowZero) {
    const auto wall = [](double x) {
        return fmt::format(
            "plane {{ z, 0 pigment {{ gradient x color_map {{ [0 rgb 0] [1 rgb 1] }} translate "
            "{}*x }} "
            "finish {{ ambient 1 diffuse 0 }} }}",
            -x);
    };
    EXPECT_NEAR(seen(5, wall(3.25)), 0.25, step);
    EXPECT_NEAR(seen(5, wall(-99.75)), 1.00001 - std::fmod(99.75, 1.00001), 2 * step);
}

}  // namespace
}  // namespace lancer::reference
