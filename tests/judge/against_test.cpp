// `validate --against` on pictures with and without inserted errors.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "judge/validate/validation_text.h"
#include "model/srgb.h"
#include "tests/judge/against_fixture.h"

namespace lancer::judge {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Planted {
    Image picture;
    std::string cause;  ///< what the words must hold
};

/// Hundredths of a pixel, up to one pixel to either side.
double drawn_shift(Drawn& drawn) {
    return (drawn.one_of(2) == 0 ? -0.01 : 0.01) * (5 + drawn.one_of(96));
}

/// The message for a picture whose rays pass (x, y) pixel beside the centres: the picture has moved
/// in the opposite direction.
std::string shift_words(double x, double y) {
    std::string words = "the picture is shifted by ";
    if (x != 0) words += fmt::format("{:g} pixel to the {}", std::abs(x), x > 0 ? "left" : "right");
    if (x != 0 && y != 0) words += " and ";
    if (y != 0) words += fmt::format("{:g} pixel {}", std::abs(y), y > 0 ? "up" : "down");
    return words + ":";
}

/// The error number `kind` with a random amount.
Planted plant(Drawn& drawn, int kind) {
    Scene scene = drawn.scene();
    const auto valued = [&](auto map) {
        Image image = rendered(scene);
        for (double& value : image.data) value = map(std::clamp(value, 0.0, 1.0));
        return image;
    };
    switch (kind) {
        case 0:
        case 1: {
            const double x = drawn_shift(drawn);
            const double y = kind == 0 ? drawn_shift(drawn) : 0;
            return {rendered(scene, x, y), shift_words(x, y)};
        }
        case 2:
        case 3: {
            const Image image = rendered(scene);
            Image turned = image;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    std::copy_n(
                        kind == 2 ? image.pixel(x, height - 1 - y) : image.pixel(width - 1 - x, y),
                        3, turned.pixel(x, y));
            return {turned, kind == 2 ? "upside down" : "left and right are exchanged"};
        }
        case 4:
            return {valued([](double v) { return srgb_encode(v); }), "gamma is applied twice"};
        case 5: {
            const double power = drawn.between(1.5, 2.5);
            return {valued([&](double v) { return std::pow(v, 1 / power); }),
                    "gamma of " + std::to_string(power).substr(0, 3)};
        }
        case 6: {
            const double factor = std::round(1000 * drawn.between(0.4, 0.95)) / 1000;
            return {valued([&](double v) { return v * factor; }),
                    "everything is " + std::to_string(factor).substr(0, 4)};
        }
        case 7: {
            const int light = drawn.one_of(2);
            const bool dimmer = drawn.one_of(2) == 0;
            for (int c = 0; c < 3; ++c)
                scene.lights[static_cast<std::size_t>(light)].color[c] *= dimmer ? 0.99 : 1.01;
            return {rendered(scene), "light " + std::to_string(light + 1) + " is " +
                                         (dimmer ? "0.99 times" : "1.01 times")};
        }
        case 8: {
            const auto object = static_cast<std::size_t>(drawn.one_of(5));
            Material& material = scene.materials[scene.objects[object].material];
            material.diffuse_transmission = material.diffuse;
            material.diffuse = material.phong = 0;
            return {rendered(scene),
                    "the normals of object " + std::to_string(object + 1) + " are flipped"};
        }
        case 9: {
            auto& lamp = std::get<PointLight>(scene.lights[0].kind);
            lamp.fade = Fade{1e-4, 2};
            for (int c = 0; c < 3; ++c) scene.lights[0].color[c] *= drawn.between(2e9, 2.1e9);
            for (int c = 1; c < 3; ++c) scene.lights[0].color[c] = scene.lights[0].color[0];
            drawn.scene().lights[0].color = Color(0.6);
            return {rendered(scene), "light 1 falls off with the square of the distance"};
        }
        case 10:
            scene.cameras[0].up = {1, 0, 0};
            return {rendered(scene), "x is up in the other picture"};
        case 11: {
            const auto object = static_cast<std::size_t>(1 + drawn.one_of(4));
            scene.objects.erase(scene.objects.begin() + static_cast<std::ptrdiff_t>(object));
            return {rendered(scene), "object " + std::to_string(object + 1) + " is missing"};
        }
        default: {
            auto& lens = std::get<PerspectiveProjection>(scene.cameras[0].projection);
            lens.fov = 2 * std::atan(std::tan(lens.fov * M_PI / 360) * height / width) * 180 / M_PI;
            return {rendered(scene), "is taken for the horizontal angle"};
        }
    }
}

TEST_F(Against, NamesTheCauseOfEachPlantedFault) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Drawn drawn(100 + seed);
        const Planted fault = plant(drawn, static_cast<int>(seed % 13));
        const Validation v = judged(drawn.scene(), fault.picture);
        EXPECT_EQ(v.verdict, Verdict::differs) << seed << said(v);
        EXPECT_THAT(v.cause.value_or("none"), HasSubstr(fault.cause)) << seed << said(v);
    }
}

TEST_F(Against, TellsHowFarAPictureIsShifted) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        Drawn drawn(300 + seed);
        const double x = drawn_shift(drawn);
        const double y = drawn_shift(drawn);
        const Validation v = judged(drawn.scene(), rendered(drawn.scene(), x, y));
        EXPECT_THAT(v.cause.value_or("none"), HasSubstr(shift_words(x, y))) << seed << said(v);
    }
    Drawn drawn(400);
    const Validation half = judged(drawn.scene(), rendered(drawn.scene(), -0.5, 0.5));
    EXPECT_THAT(half.cause.value_or("none"), HasSubstr("(--pixel-center 0,1)")) << said(half);
}

TEST_F(Against, NamesNoCauseWhereThereIsNoFault) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Drawn drawn(200 + seed);
        const Validation v = judged(drawn.scene(), rendered(drawn.scene()));
        EXPECT_EQ(v.verdict, Verdict::agrees) << seed << said(v);
        EXPECT_FALSE(v.cause) << seed << said(v);
    }
}

TEST_F(Against, NamesNoCauseOfWhatIsNone) {
    // Noise, two errors at once, and a spot: all differ, and no simple explanation exists.
    Drawn drawn(7);
    Image noise = rendered(drawn.scene());
    for (double& value : noise.data) value += drawn.between(-0.01, 0.01);
    Image spot = rendered(drawn.scene());
    for (int y = 10; y < 30; ++y)
        for (int x = 20; x < 50; ++x) spot.pixel(x, y)[1] *= 0.01 * x;
    Scene two = drawn.scene();
    two.objects.erase(two.objects.begin() + 1);
    two.cameras[0].position.x += 0.3;
    for (const Image& picture : {noise, spot, rendered(two)}) {
        const Validation v = judged(drawn.scene(), picture);
        EXPECT_EQ(v.verdict, Verdict::differs) << said(v);
        EXPECT_FALSE(v.cause) << said(v);
    }
}

TEST_F(Against, ReadsWhatItIsTold) {
    Drawn drawn(3);
    const Scene& scene = drawn.scene();
    Reading corner;
    corner.center_x = corner.center_y = 0;
    EXPECT_EQ(judged(scene, rendered(scene, -0.5, -0.5), corner).verdict, Verdict::agrees);
    Image dark = rendered(scene);
    for (double& value : dark.data) value *= 0.25;
    Reading quarter;
    quarter.exposure = 0.25;
    EXPECT_EQ(judged(scene, dark, quarter).verdict, Verdict::agrees);
    Image powers = rendered(scene);
    for (double& value : powers.data) value = std::pow(std::clamp(value, 0.0, 1.0), 1 / 2.2);
    Reading gamma;
    gamma.encoding = {Encoding::Kind::gamma, 2.2};
    EXPECT_EQ(judged(scene, powers, gamma).verdict, Verdict::agrees);
    EXPECT_EQ(judged(scene, powers).verdict, Verdict::differs);
    EXPECT_EQ(judged(scene, rendered(scene), {}, "other.exr").verdict, Verdict::agrees);
}

TEST_F(Against, RefusesWhatCannotBeJudged) {
    Drawn drawn(5);
    const Scene& scene = drawn.scene();
    const Image picture = rendered(scene);
    const auto first = [](const Validation& v) { return v.reasons.empty() ? "" : v.reasons[0]; };

    const Validation coarse = judged(scene, picture, {}, "other.png", 8);
    EXPECT_EQ(coarse.verdict, Verdict::failed);
    EXPECT_THAT(first(coarse),
                HasSubstr("has only 8 bits per channel, which is too coarse to be judged"));

    const Validation cropped = judged(scene, Image(50, 48));
    EXPECT_EQ(cropped.verdict, Verdict::differs);
    EXPECT_THAT(first(cropped), HasSubstr("50 x 48 pixels, but the scene's 64 x 48 have other "
                                          "proportions: the picture is cropped"));

    Image holey(width, height, 4);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::copy_n(picture.pixel(x, y), 3, holey.pixel(x, y));
            holey.pixel(x, y)[3] = 1;
        }
    }
    EXPECT_EQ(judged(scene, holey).verdict, Verdict::agrees) << "an alpha of 1 says nothing";
    holey.pixel(3, 4)[3] = 0.5;
    const Validation alpha = judged(scene, holey);
    EXPECT_EQ(alpha.verdict, Verdict::failed);
    EXPECT_THAT(first(alpha), HasSubstr("is not opaque"));
    EXPECT_THAT(first(alpha), HasSubstr("at (3, 4)"));

    Image bad = picture;
    bad.pixel(5, 6)[1] = std::numeric_limits<double>::quiet_NaN();
    const Validation nan = judged(scene, bad, {}, "nan.exr");
    EXPECT_EQ(nan.verdict, Verdict::differs);
    EXPECT_THAT(first(nan), HasSubstr("1 value that is NaN or infinite, the first at (5, 6)"));

    EXPECT_EQ(judged(scene, picture).verdict, Verdict::agrees);  // writes it
    AgainstJob job;
    job.scene.scene = std::make_shared<const Scene>(scene);
    job.scene.view = {0, 80, 60};
    job.size_is_given = true;
    job.picture = folder_.path().string() + "/other.png";  // 64 x 48
    const Validation sized = validate_against(job);
    EXPECT_EQ(sized.verdict, Verdict::differs);
    EXPECT_THAT(first(sized), HasSubstr("has 64 x 48 pixels, but --size says 80 x 60"));
    job.picture = folder_.path().string() + "/text.png";
    io::write_file(job.picture, "no picture");
    const Validation text = validate_against(job);
    EXPECT_EQ(text.verdict, Verdict::failed);
    EXPECT_THAT(first(text), HasSubstr("text.png"));
    job.picture = folder_.path().string() + "/nowhere.png";
    EXPECT_EQ(validate_against(job).verdict, Verdict::failed);
    EXPECT_THROW(picture_in_folder(folder_.path().string(), "a/nowhere.lancer"), FileError);
    EXPECT_THAT(picture_in_folder(folder_.path().string(), "a/other.lancer"),
                HasSubstr("/other.png"));
}

TEST_F(Against, HalfFloatsAreTooCoarse) {
    Drawn drawn(6);
    Image half = rendered(drawn.scene());
    for (double& value : half.data) {
        int exponent = 0;
        const double digits = std::frexp(value, &exponent);
        value = std::ldexp(std::round(std::ldexp(digits, 11)), exponent - 11);
    }
    const Validation v = judged(drawn.scene(), half, {}, "half.exr");
    EXPECT_EQ(v.verdict, Verdict::failed);
    EXPECT_THAT(said(v), HasSubstr("11 binary digits"));
}

TEST_F(Against, SaysWhichObjectsDiffer) {
    Drawn drawn(8);
    Scene other = drawn.scene();
    other.materials[other.objects[2].material].phong += 0.2;
    other.materials[other.objects[2].material].shininess = 5;
    const Validation v = judged(drawn.scene(), rendered(other));
    EXPECT_EQ(v.verdict, Verdict::differs);
    EXPECT_THAT(said(v), HasSubstr("of them show object 3"));
    EXPECT_THAT(said(v), HasSubstr("no single cause that was tried"));
    EXPECT_THAT(said(v), HasSubstr("a picture alone cannot show whether some of them are"));
    const std::string json = validations_to_json({v}, "");
    EXPECT_THAT(json, HasSubstr("not_decidable_from_a_picture"));
    EXPECT_THAT(json, Not(HasSubstr("\"coincident\"")));
}

}  // namespace
}  // namespace lancer::judge
