#include "judge/against/reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "model/diagnostic.h"
#include "model/srgb.h"

namespace lancer::judge {

namespace {

double light_of(double number, const Encoding& encoding) {
    switch (encoding.kind) {
        case Encoding::Kind::automatic:
        case Encoding::Kind::linear:
            return number;
        case Encoding::Kind::srgb:
            return std::isfinite(number) ? srgb_decode(number) : number;
        case Encoding::Kind::gamma:
            return number > 0 ? elementary::pow(number, encoding.exponent) : number;
    }
    return number;
}

/// Whether there are more than `many` different values. With fewer, the values say nothing about
/// the file's precision.
bool has_many_values(const std::vector<double>& values, std::size_t many) {
    std::set<double> seen;
    for (const double value : values) {
        seen.insert(value);
        if (seen.size() > many) return true;
    }
    return false;
}

/// Whether all values are multiples of 1/255.
bool has_8_bits(const Image& numbers) {
    const auto is_step = [](double v) { return std::abs(v * 255 - std::round(v * 255)) < 1e-6; };
    return std::all_of(numbers.data.begin(), numbers.data.end(), is_step) &&
           has_many_values(numbers.data, 2);
}

bool has_16_bits(const Image& numbers) {
    return std::all_of(numbers.data.begin(), numbers.data.end(), [](double v) {
        return v >= 0 && v <= 1 && std::abs(v * 65535 - std::round(v * 65535)) < 1e-6;
    });
}

/// The light of values that are half a step of 16 bits higher, except for 0 and 1, which may be
/// clipped. Nothing when the file names a curve that is neither linear nor sRGB.
Image half_a_step_up(const Image& numbers, const Image& light, Encoding encoding) {
    if (encoding.kind == Encoding::Kind::automatic) {
        if (light.data == numbers.data) {
            encoding.kind = Encoding::Kind::linear;
        } else {
            encoding.kind = Encoding::Kind::srgb;
            for (std::size_t i = 0; i < light.data.size(); ++i)
                if (std::abs(light.data[i] - light_of(numbers.data[i], encoding)) > 1e-9) return {};
        }
    }
    Image raised = light;
    for (std::size_t i = 0; i < light.data.size(); ++i) {
        const double number = numbers.data[i];
        if (number > 0 && number < 1) raised.data[i] = light_of(number + 0.5 / 65535, encoding);
    }
    return raised;
}

/// Whether all values fit the 11 binary digits of half floats.
bool has_11_digits(const Image& numbers) {
    const auto is_half = [](double v) {
        int exponent = 0;
        const double digits = std::ldexp(std::frexp(v, &exponent), 11);
        return !std::isfinite(v) || digits == std::round(digits);
    };
    return std::all_of(numbers.data.begin(), numbers.data.end(), is_half) &&
           has_many_values(numbers.data, 16);
}

/// Half of the largest step in light of a file with 8 bits, near white.
double half_step_of_8_bits(const Image& numbers, const Image& light) {
    double half = 0;
    // The slope of the curve follows from the values and their light.
    for (std::size_t i = 0; i < numbers.data.size(); ++i) {
        const double n = numbers.data[i];
        if (!(n > 0 && n <= 1) || !(light.data[i] > 0)) continue;
        half = std::max(half, 0.5 / 255 * light.data[i] / n);
    }
    return half;
}

double half_step_of_halves(const Image& numbers) {
    double largest = 0;
    for (const double v : numbers.data)
        if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
    int exponent = 0;
    std::frexp(std::min(largest, 1.0), &exponent);
    return std::ldexp(1.0, exponent - 12);
}

void refuse_coarse(const std::string& path, const Image& numbers, const Image& light,
                   double tolerance) {
    const bool bits_8 = has_8_bits(numbers);
    if (!bits_8 && !has_11_digits(numbers)) return;
    const double half = bits_8 ? half_step_of_8_bits(numbers, light) : half_step_of_halves(numbers);
    if (half <= tolerance) return;
    throw FileError(
        fmt::format("'{}' has only {} per channel, which is too coarse to be judged: rounding "
                    "alone changes a value by up to {:.2g}, but the threshold is {:g}. Write the "
                    "picture with 16 bits or as floats",
                    path, bits_8 ? "8 bits" : "11 binary digits (half floats)", half, tolerance));
}

void refuse_alpha(const std::string& path, const Image& image) {
    if (image.color_channels() != 4) return;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.pixel(x, y)[3] == 1) continue;
            throw FileError(
                fmt::format("'{}' is not opaque, alpha {:g} at ({}, {}): Lancer shows the scene's "
                            "background there. Write the picture without alpha, over that colour",
                            path, image.pixel(x, y)[3], x, y));
        }
    }
}

Image without_alpha(const Image& image) {
    Image result(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) std::copy_n(image.pixel(x, y), 3, result.pixel(x, y));
    return result;
}

}  // namespace

ForeignPicture read_foreign_picture(const std::string& path, const Encoding& encoding,
                                    double tolerance) {
    const Image numbers = in_color(io::read_image(path, io::ColorSpace::linear));
    refuse_alpha(path, numbers);
    Image light = numbers;
    if (encoding.kind == Encoding::Kind::automatic) light = in_color(io::read_image(path));
    for (double& value : light.data) value = light_of(value, encoding);
    if (light.width != numbers.width || light.data.size() != numbers.data.size())
        throw FileError(fmt::format("'{}' was changed while it was read", path));
    refuse_coarse(path, numbers, light, tolerance);
    ForeignPicture picture{without_alpha(light), {}};
    if (has_16_bits(numbers))
        picture.raised = half_a_step_up(without_alpha(numbers), picture.light, encoding);
    return picture;
}

bool is_rounded_down(const Image& ours, const ForeignPicture& picture) {
    constexpr std::size_t least_values = 64;
    if (picture.raised.data.empty()) return false;
    std::set<double> values;  // equal values count once
    std::size_t seen = 0;
    std::size_t below = 0;    // what rounding down leaves over
    std::size_t nearest = 0;  // what rounding to the nearest leaves over
    for (std::size_t i = 0; i < ours.data.size(); ++i) {
        const double half = picture.raised.data[i] - picture.light.data[i];
        const double lost = ours.data[i] - picture.light.data[i];
        if (!(half > 0) || std::abs(lost) > 4 * half || !values.insert(ours.data[i]).second)
            continue;
        ++seen;
        below += lost > -0.05 * half && lost < 2.05 * half ? 1 : 0;
        nearest += std::abs(lost) < 1.05 * half ? 1 : 0;
    }
    return seen >= least_values && 100 * below > 99 * seen && 4 * nearest < 3 * seen;
}

}  // namespace lancer::judge
