#include "model/io/texture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "model/diagnostic.h"

namespace lancer::io {

Image read_texture(const std::string& path, ColorSpace space) {
    Image image = in_color(read_image(path, space));
    const auto wrong = std::find_if(image.data.begin(), image.data.end(),
                                    [](double value) { return !std::isfinite(value); });
    if (wrong == image.data.end()) return image;
    const auto index = static_cast<std::size_t>(wrong - image.data.begin());
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t pixel = index / channels;
    const auto width = static_cast<std::size_t>(image.width);
    constexpr std::array<const char*, 4> names{"red", "green", "blue", "alpha"};
    throw FileError(fmt::format("cannot use '{}': {} at ({}, {}) is {}", path,
                                names[index % channels], pixel % width, pixel / width,
                                std::isnan(*wrong) ? "NaN" : "infinite"));
}

}  // namespace lancer::io
