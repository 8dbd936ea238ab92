// Typical errors of ray tracers, inserted one by one into complex scenes: each is named, and no
// shift is reported in addition.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "model/srgb.h"
#include "tests/judge/against_fixture.h"

namespace lancer::judge {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// The drawn balls, and boxes, cylinders, glass, an image, a sky and mirrors that face each other.
Drawn furnished(unsigned seed) {
    Drawn drawn(seed);
    Scene& scene = drawn.scene();
    for (Material& material : scene.materials) {
        material.phong = std::max(material.phong, 0.1);
        material.shininess = drawn.between(8, 20);
    }
    scene.materials[scene.objects[0].material].reflection = Color(0.4);
    scene.materials[scene.objects[4].material].reflection = Color(0.6, 0.5, 0.6);
    scene.sky = Gradient{{0, 1, 0}, {{-1, {0.1, 0.1, 0.1}}, {1, {0.3, 0.5, 0.9}}}};
    for (const double x : {-2.4, 2.2}) {
        Material material = drawn.material();
        material.blinn = 0.4;
        material.phong = 0;
        material.roughness = 0.1;
        const double half = drawn.between(0.25, 0.35);
        const double z = drawn.between(1.6, 2.2);
        drawn.show(Box{{x - half, 0, z - half}, {x + half, drawn.between(0.6, 0.9), z + half}},
                   material);
        drawn.show(Cylinder{{0.5 * x, 0, z + 0.9}, {0.5 * x, 0.4, z + 0.9}, 0.2}, material);
    }
    auto image = std::make_shared<Image>(8, 8);
    for (double& value : image->data) value = drawn.between(0.1, 0.9);
    scene.images.push_back({"drawn", false, image});
    ImageTexture wrapped;
    wrapped.mapping = ImageTexture::Mapping::spherical;
    scene.textures.push_back({wrapped, {}});
    scene.materials[scene.objects[1].material].texture =
        static_cast<std::uint32_t>(scene.textures.size() - 1);
    Material glass = drawn.material();
    glass.ambient = glass.diffuse = 0.05;
    glass.transmission = 0.5;
    glass.filter = 0.3;
    glass.ior = drawn.between(1.2, 1.4);
    glass.reflection = Color(1);
    glass.fresnel = true;
    glass.absorption = {0.2, 0.6, 0.4};
    drawn.show(Sphere{{drawn.between(-0.2, 0.2), 0.8, 3.3}, 0.45}, glass);
    return drawn;
}

struct Fault {
    const char* words;
    std::function<void(Scene&)> plant;
};

template <class Which>
std::function<void(Scene&)> in_materials(Which change) {
    return [change](Scene& scene) {
        for (Material& material : scene.materials) change(material);
    };
}

template <class ShapeKind>
void light_from_wrong_side(Scene& scene) {
    for (Object& object : scene.objects) {
        if (!std::holds_alternative<ShapeKind>(object.shape)) continue;
        Material material = scene.materials[object.material];
        material.diffuse = material.phong = material.blinn = 0;
        object.material = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(material);
    }
}

template <class ShapeKind>
void remove(Scene& scene) {
    std::erase_if(scene.objects,
                  [](const Object& o) { return std::holds_alternative<ShapeKind>(o.shape); });
}

/// The image read so that its pixel (x, y) is `from(x, y)`.
template <class From>
std::function<void(Scene&)> in_image(From from) {
    return [from](Scene& scene) {
        const Image& image = *scene.images[0].pixels;
        Image other = image;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const auto [column, row] = from(x, y);
                std::copy_n(image.pixel(column, row), 3, other.pixel(x, y));
            }
        }
        scene.images[0].pixels = std::make_shared<const Image>(other);
    };
}

class AgainstCauses : public Against {
  protected:
    void expect_named(unsigned seed, const std::vector<Fault>& faults) {
        for (const Fault& fault : faults) {
            Drawn drawn = furnished(seed++);
            Scene other = drawn.scene();
            fault.plant(other);
            expect_said(judged(drawn.scene(), rendered(other)), fault.words);
        }
    }
    static void expect_said(const Validation& v, const std::string& words) {
        EXPECT_EQ(v.verdict, Verdict::differs) << words;
        EXPECT_THAT(v.cause.value_or("none"), HasSubstr(words)) << said(v);
        EXPECT_THAT(v.reasons, Not(Contains(HasSubstr("the other picture is shifted"))))
            << words << "\n"
            << said(v);
    }
};

TEST_F(AgainstCauses, KindsOfShapes) {
    expect_named(500, {
                          {"the normals of all boxes are flipped", light_from_wrong_side<Box>},
                          {"the normals of all spheres are flipped", light_from_wrong_side<Sphere>},
                          {"the normals of all cylinders are", light_from_wrong_side<Cylinder>},
                          {"all boxes are missing", remove<Box>},
                          {"all spheres are missing", remove<Sphere>},
                          {"all cylinders are missing", remove<Cylinder>},
                      });
}

TEST_F(AgainstCauses, ColoursThroughACurve) {
    const auto colours = [](double (*curve)(double)) {
        return [curve](Scene& scene) {
            const auto change = [&](Color& color) {
                for (int c = 0; c < 3; ++c) color[c] = curve(color[c]);
            };
            for (Material& material : scene.materials) change(material.color);
            auto& floor = std::get<Checker>(scene.textures[0].pattern);
            change(floor.even);
            change(floor.odd);
        };
    };
    expect_named(
        520,
        {
            {"the materials' colours are decoded by the sRGB curve", colours(srgb_decode)},
            {"the materials' colours are still encoded by the sRGB curve", colours(srgb_encode)},
            {"the materials' colours are raised to the power of 2.2",
             colours([](double v) { return std::pow(v, 2.2); })},
            {"the materials' colours are squared", colours([](double v) { return v * v; })},
            {"the materials' colours are replaced by their square roots",
             colours([](double v) { return std::sqrt(v); })},
        });
}

TEST_F(AgainstCauses, Highlights) {
    const auto exponents = [](double factor) {
        return in_materials([factor](Material& m) {
            m.shininess *= factor;
            m.roughness /= factor;
        });
    };
    expect_named(540, {
                          {"there are no highlights",
                           in_materials([](Material& m) { m.phong = m.blinn = 0; })},
                          {"the exponents of highlights are twice", exponents(2)},
                          {"the exponents of highlights are half", exponents(0.5)},
                          {"the exponents of phong highlights are half",
                           in_materials([](Material& m) { m.shininess *= 0.5; })},
                          {"the exponents of blinn highlights are twice",
                           in_materials([](Material& m) { m.roughness /= 2; })},
                          {"phong highlights use the half vector", in_materials([](Material& m) {
                               if (m.phong == 0) return;
                               m.blinn = m.phong;
                               m.roughness = 1 / m.shininess;
                               m.phong = 0;
                           })},
                          {"blinn highlights use the mirrored dir", in_materials([](Material& m) {
                               if (m.blinn == 0) return;
                               m.phong = m.blinn;
                               m.shininess = 1 / m.roughness;
                               m.blinn = 0;
                           })},
                      });
}

TEST_F(AgainstCauses, Textures) {
    using Place = std::pair<int, int>;
    expect_named(560, {
                          {"textures are upside down", in_image([](int x, int y) {
                               return Place{x, 7 - y};
                           })},
                          {"textures are mirrored", in_image([](int x, int y) {
                               return Place{7 - x, y};
                           })},
                          {"textures show the nearest texel's colour",
                           [](Scene& s) {
                               std::get<ImageTexture>(s.textures[1].pattern).filter =
                                   ImageTexture::Filter::nearest;
                           }},
                          {"the two colours of checkers are exchanged",
                           [](Scene& s) {
                               auto& floor = std::get<Checker>(s.textures[0].pattern);
                               std::swap(floor.even, floor.odd);
                           }},
                          {"the values of textures' images are decoded",
                           [](Scene& s) {
                               Image image = *s.images[0].pixels;
                               for (double& value : image.data) value = srgb_decode(value);
                               s.images[0].pixels = std::make_shared<const Image>(image);
                           }},
                      });
}

TEST_F(AgainstCauses, GlassAndMirrors) {
    expect_named(
        580,
        {
            {"absorption inside of bodies is left out",
             in_materials([](Material& m) { m.absorption = Color(0); })},
            {"fresnel is left out", in_materials([](Material& m) { m.fresnel = false; })},
            {"surfaces with fresnel reflect nothing", in_materials([](Material& m) {
                 if (m.fresnel) m.reflection = Color(0);
             })},
            {"nothing is reflected", in_materials([](Material& m) { m.reflection = Color(0); })},
            {"ior is inverted", in_materials([](Material& m) { m.ior = 1 / m.ior; })},
            {"every ior is 1.5", in_materials([](Material& m) {
                 if (m.ior != 1) m.ior = 1.5;
             })},
            {"light is not bent", in_materials([](Material& m) { m.ior = 1; })},
            {"filter is taken for transmission", in_materials([](Material& m) {
                 m.transmission += m.filter;
                 m.filter = 0;
             })},
            {"transparent objects cast no shadow",
             [](Scene& s) { s.objects.back().casts_shadow = false; }},
            {"the sky is left out", [](Scene& s) { s.sky = std::nullopt; }},
        });
}

TEST_F(AgainstCauses, LightOfTheSky) {
    const auto sky = [](const Color& factor) {
        return [factor](Scene& s) {
            for (Gradient::Stop& stop : s.sky->stops) stop.color *= factor;
        };
    };
    expect_named(590, {{"the sky is 2 times as bright", sky(Color(2))},
                       {"the sky is 0.5 times as bright", sky(Color(0.5))},
                       {"the sky is missing", sky(Color(0))},
                       {"the sky is 1, 1 and 3 times as bright", sky({1, 1, 3})}});
}

TEST_F(AgainstCauses, LevelsOfRecursion) {
    const auto deep = [](int depth) { return [depth](Scene& s) { s.settings.max_depth = depth; }; };
    expect_named(600, {{"rays are followed 1 level deep, but the scene says 4", deep(1)},
                       {"rays are followed 2 levels deep", deep(2)},
                       {"rays are followed 3 levels deep", deep(3)},
                       {"rays are followed 5 levels deep", deep(5)},
                       {"rays are followed 8 levels deep", deep(8)}});
}

TEST_F(AgainstCauses, ASparedBorderHidesNoShift) {
    for (unsigned seed = 640; seed < 643; ++seed) {
        Drawn drawn(seed);
        const Image right = rendered(drawn.scene());
        Image moved = rendered(drawn.scene(), 1, 0);
        for (int y = 0; y < height; ++y)
            std::copy_n(right.pixel(width - 1, y), 3, moved.pixel(width - 1, y));
        const Validation v = judged(drawn.scene(), moved);
        EXPECT_THAT(v.cause.value_or("none"), HasSubstr("shifted by 1 pixel to the left"))
            << said(v);
        Image down = rendered(drawn.scene(), 0, -1);
        std::fill_n(down.pixel(0, 0), 3 * width, 0.0);
        const Validation black = judged(drawn.scene(), down);
        EXPECT_THAT(black.cause.value_or("none"), HasSubstr("shifted by 1 pixel down"))
            << said(black);
    }
}

TEST_F(AgainstCauses, NoneWhereThereIsNone) {
    for (unsigned seed = 660; seed < 670; ++seed) {
        Drawn drawn = furnished(seed);
        const Image right = rendered(drawn.scene());
        const Validation agrees = judged(drawn.scene(), right);
        EXPECT_EQ(agrees.verdict, Verdict::agrees) << said(agrees);
        EXPECT_FALSE(agrees.cause) << said(agrees);
        if (seed % 5 != 0) continue;
        Image noise = right;
        for (double& value : noise.data) value += drawn.between(-0.01, 0.01);
        const Validation noisy = judged(drawn.scene(), noise);
        EXPECT_EQ(noisy.verdict, Verdict::differs);
        EXPECT_FALSE(noisy.cause) << said(noisy);
    }
}

}  // namespace
}  // namespace lancer::judge
