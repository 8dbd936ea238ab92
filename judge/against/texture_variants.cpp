#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "judge/against/scene_variants.h"
#include "model/srgb.h"

namespace lancer::judge {

namespace {

Image turned_over(const Image& image, bool columns, bool rows) {
    Image turned = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            std::copy_n(
                image.pixel(columns ? image.width - 1 - x : x, rows ? image.height - 1 - y : y),
                image.channels, turned.pixel(x, y));
        }
    }
    return turned;
}

template <class Change>
void change_images(Scene& scene, const Change& change) {
    for (SceneImage& image : scene.images)
        image.pixels = std::make_shared<const Image>(change(*image.pixels));
}

/// Changes all textures with this kind of pattern.
template <class Pattern, class Change>
void change_patterns(Scene& scene, const Change& change) {
    for (Texture& texture : scene.textures)
        if (auto* pattern = std::get_if<Pattern>(&texture.pattern)) change(*pattern);
}

template <class Pattern>
bool has(const Scene& scene) {
    return std::any_of(scene.textures.begin(), scene.textures.end(), [](const Texture& texture) {
        return std::holds_alternative<Pattern>(texture.pattern);
    });
}

void add_images(std::vector<SceneVariant>& variants) {
    const auto add_turned = [&](const char* words, bool columns, bool rows) {
        variants.push_back({words, [columns, rows](Scene& scene) {
                                change_images(scene, [&](const Image& image) {
                                    return turned_over(image, columns, rows);
                                });
                            }});
    };
    add_turned("textures are upside down: v counts rows from the top", false, true);
    add_turned("textures are mirrored: u runs the other way", true, false);
    add_turned("textures are turned by half a turn: u and v run the other way", true, true);
    const auto add_filter = [&](const char* words, ImageTexture::Filter filter) {
        variants.push_back({words, [filter](Scene& scene) {
                                change_patterns<ImageTexture>(
                                    scene, [&](ImageTexture& image) { image.filter = filter; });
                            }});
    };
    add_filter("textures show the nearest texel's colour, without interpolation",
               ImageTexture::Filter::nearest);
    add_filter("all textures are interpolated", ImageTexture::Filter::bilinear);
}

using Curve = double (*)(double);

Color through(Curve curve, Color color) {
    for (int c = 0; c < 3; ++c) color[c] = color[c] > 0 ? curve(color[c]) : color[c];
    return color;
}

void curve_materials(Scene& scene, Curve curve) {
    for (Material& material : scene.materials) material.color = through(curve, material.color);
    change_patterns<Checker>(scene, [&](Checker& checker) {
        checker.even = through(curve, checker.even);
        checker.odd = through(curve, checker.odd);
    });
    change_patterns<Gradient>(scene, [&](Gradient& gradient) {
        for (Gradient::Stop& stop : gradient.stops) stop.color = through(curve, stop.color);
    });
}

void curve_images(Scene& scene, Curve curve) {
    change_images(scene, [&](Image image) {
        for (std::size_t i = 0; i < image.data.size(); ++i) {
            double& value = image.data[i];
            const bool is_alpha = i % static_cast<std::size_t>(image.channels) == 3;
            if (!is_alpha && value > 0) value = curve(value);
        }
        return image;
    });
}

void curve_everything(Scene& scene, Curve curve) {
    curve_materials(scene, curve);
    for (Material& material : scene.materials) {
        material.reflection = through(curve, material.reflection);
        material.emission = through(curve, material.emission);
    }
    for (Light& light : scene.lights) light.color = through(curve, light.color);
    scene.ambient = through(curve, scene.ambient);
    scene.background = through(curve, scene.background);
    if (!scene.sky) return;
    for (Gradient::Stop& stop : scene.sky->stops) stop.color = through(curve, stop.color);
}

struct NamedCurve {
    const char* words;
    Curve curve;
};
constexpr NamedCurve curves[] = {
    {"decoded by the sRGB curve once too often", [](double v) { return srgb_decode(v); }},
    {"still encoded by the sRGB curve", [](double v) { return srgb_encode(v); }},
    {"raised to the power of 2.2", [](double v) { return elementary::pow(v, 2.2); }},
    {"raised to the power of 1/2.2", [](double v) { return elementary::pow(v, 1 / 2.2); }},
    {"squared", [](double v) { return v * v; }},
    {"replaced by their square roots", [](double v) { return std::sqrt(v); }},
};

}  // namespace

void add_texture_variants(std::vector<SceneVariant>& variants, const Scene& scene) {
    if (has<ImageTexture>(scene)) add_images(variants);
    if (has<Checker>(scene)) {
        variants.push_back({"the two colours of checkers are exchanged", [](Scene& s) {
                                change_patterns<Checker>(s, [](Checker& checker) {
                                    std::swap(checker.even, checker.odd);
                                });
                            }});
    }
    if (!scene.textures.empty()) {
        variants.push_back({"textures are left out: materials have their plain colours",
                            [](Scene& s) { s.settings.textures = false; }});
    }
    const auto add = [&](const char* what, auto change) {
        for (const NamedCurve& named : curves) {
            variants.push_back({std::string(what) + " are " + named.words,
                                [change, curve = named.curve](Scene& s) { change(s, curve); }});
        }
    };
    add("the materials' colours", curve_materials);
    if (has<ImageTexture>(scene)) {
        add("the values of textures' images", curve_images);
        add("the materials' colours and the values of textures' images", [](Scene& s, Curve curve) {
            curve_materials(s, curve);
            curve_images(s, curve);
        });
    }
    add("all colours of the scene", curve_everything);
}

}  // namespace lancer::judge
