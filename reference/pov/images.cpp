#include "reference/pov/images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/io/png_file.h"
#include "reference/pov/choices.h"

namespace lancer::reference::pov {

namespace {

/// The image as a file, and the largest error of the file's values.
struct PngFile {
    std::string bytes;
    double error{};
};

/// Encodes with 16 bits, which hold 8-bit values exactly.
PngFile encoded(const SceneImage& image, bool linear) {
    const Image& pixels = *image.pixels;
    PngFile file{io::encode_png(pixels, {16, linear}, image.path)};
    const Image back = io::decode_png(file.bytes, image.path, io::ColorSpace::automatic);
    auto value = back.data.begin();
    for (const double wanted : pixels.data)
        file.error = std::max(file.error, std::abs(*value++ - wanted));
    return file;
}

}  // namespace

std::string image_file_words(Writer& writer, std::uint32_t index, const SourceSpan& where) {
    const auto known = writer.image_words.find(index);
    if (known != writer.image_words.end()) return known->second;

    const SceneImage& image = writer.scene.images[index];
    const std::vector<double>& values = image.pixels->data;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (*low < 0 || *high > 1)
        writer.refuse(where,
                      "the image '" + image.path +
                          "' contains values outside 0 to 1, which a PNG cannot store",
                      "scale the image's values and the lights instead");
    PngFile file = encoded(image, false);
    const char* gamma = "srgb";
    if (file.error > rounding_of_values) {  // linear: at most half a step off
        file = encoded(image, true);
        gamma = "1.0";
    }
    if (file.error > rounding_of_values)
        writer.approximate(
            where, fmt::format("image '{}' rounded to 16 bits, off by at most {:.1e}", image.path,
                               file.error));
    const std::string name = fmt::format("{}-{}.png", identifier(writer.options.name), index);
    std::string words = fmt::format("png \"{}\" gamma {}", name, gamma);
    writer.result.assets.push_back({name, std::move(file.bytes)});
    writer.image_words.emplace(index, words);
    return words;
}

}  // namespace lancer::reference::pov
