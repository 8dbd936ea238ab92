#include "reference/compare/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/elementary.h"
#include "model/math.h"
#include "reference/compare/color_map.h"
#include "reference/compare/numerals.h"

namespace lancer::reference {

namespace {

constexpr int decades = 6;  // from heat_lowest to heat_highest
constexpr int margin = 10;  // left and right of the bar: half of a numeral
constexpr int narrowest = 2 * margin + decades * 20;
constexpr int gap = 4;
constexpr int bar_height = 8;
constexpr int scale_height = gap + bar_height + 3 + numeral_height + gap;

const Color ink{0.6, 0.6, 0.6};

Color color_of(double difference) {
    if (!std::isfinite(difference)) return {1, 1, 1};
    if (difference <= heat_lowest) return magma(0);
    return magma(1 + elementary::log(difference / heat_highest) / elementary::log(10.0) / decades);
}

void put(Image& image, int x, int y, const Color& color) {
    double* pixel = image.pixel(x, y);
    pixel[0] = color.x;
    pixel[1] = color.y;
    pixel[2] = color.z;
}

void draw_scale(Image& image, int top) {
    const int left = margin;
    const int right = image.width - margin - 1;
    for (int x = left; x <= right; ++x) {
        const Color color = magma(static_cast<double>(x - left) / (right - left));
        for (int y = 0; y < bar_height; ++y) put(image, x, top + gap + y, color);
    }
    for (int i = 0; i <= decades; ++i) {
        const int x = left + (right - left) * i / decades;
        const int foot = top + gap + bar_height;
        put(image, x, foot, ink);
        put(image, x, foot + 1, ink);
        const std::string label = i == decades ? "1" : fmt::format("1e-{}", decades - i);
        draw_numerals(image, x - numerals_width(label) / 2, foot + 3, label, ink);
    }
}

}  // namespace

Image heat_map(const std::vector<double>& differences, int width, bool scale) {
    assert(width > 0 && !differences.empty());
    const int height = static_cast<int>(differences.size() / static_cast<std::size_t>(width));
    Image image(scale ? std::max(width, narrowest) : width, height + (scale ? scale_height : 0));
    std::size_t i = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) put(image, x, y, color_of(differences[i++]));
    }
    if (scale) draw_scale(image, height);
    return image;
}

}  // namespace lancer::reference
