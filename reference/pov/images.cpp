#include "reference/pov/images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/io/png_file.h"

namespace lancer::reference::pov {

namespace {

/// IEC 61966-2-1, decoding; written here and not taken from the reader of images, which it judges.
double srgb_to_linear(double v) {
    return v <= 0.04045 ? v / 12.92 : elementary::pow((v + 0.055) / 1.055, 2.4);
}

double linear_to_srgb(double v) {
    return v <= 0.0031308 ? v * 12.92 : 1.055 * elementary::pow(v, 1 / 2.4) - 0.055;
}

/// How the values of one image are kept in whole numbers.
struct Encoding {
    int bits = 16;
    bool srgb = false;

    double steps() const { return bits == 8 ? 255.0 : 65535.0; }
    std::uint16_t encode(double linear) const {
        const double v = srgb ? linear_to_srgb(linear) : linear;
        return static_cast<std::uint16_t>(std::floor(std::clamp(v, 0.0, 1.0) * steps() + 0.5));
    }
    double decode(std::uint16_t value) const {
        const double v = value / steps();
        return srgb ? srgb_to_linear(v) : v;
    }
};

/// Alpha is never curved, whatever the colours are.
Encoding for_channel(const Encoding& encoding, const Image& image, std::size_t i) {
    const bool alpha = image.channels == 4 && i % 4 == 3;
    return {encoding.bits, encoding.srgb && !alpha};
}

double largest_error(const Image& image, const Encoding& encoding) {
    double worst = 0;
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        const Encoding channel = for_channel(encoding, image, i);
        const double back = channel.decode(channel.encode(image.data[i]));
        worst = std::max(worst, std::abs(back - image.data[i]));
    }
    return worst;
}

}  // namespace

std::string image_file_words(Writer& writer, std::uint32_t index, const SourceSpan& where) {
    const auto known = writer.image_words.find(index);
    if (known != writer.image_words.end()) return known->second;

    const SceneImage& scene_image = writer.scene.images[index];
    const Image& image = *scene_image.pixels;
    // The first that holds every value; 16 linear bits, the last, are half a step off at worst.
    Encoding chosen{};
    double error = 1;
    for (const Encoding encoding :
         {Encoding{8, true}, Encoding{8, false}, Encoding{16, true}, Encoding{16, false}}) {
        chosen = encoding;
        error = largest_error(image, encoding);
        if (error <= 1e-9) break;
    }
    if (error > 1.0 / 65535)
        writer.refuse(
            where,
            "the image '" + scene_image.path + "' holds values outside 0 to 1, which no PNG can",
            "scale the image's values and the lights instead");
    else if (error > 1e-9)
        writer.approximate(where,
                           fmt::format("image '{}' rounded to 16 bits, off by at most {:.1e}",
                                       scene_image.path, error));
    const Asset asset{fmt::format("{}-{}.png", identifier(writer.options.name, 64), index),
                      io::encode_png(image, {chosen.bits, !chosen.srgb}, scene_image.path)};
    writer.result.assets.push_back(asset);
    std::string words =
        fmt::format("png \"{}\" gamma {}", asset.name, chosen.srgb ? "srgb" : "1.0");
    writer.image_words.emplace(index, words);
    return words;
}

}  // namespace lancer::reference::pov
