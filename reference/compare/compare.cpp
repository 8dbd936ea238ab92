#include "reference/compare/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "model/elementary.h"
#include "reference/compare/flip.h"

namespace lancer::reference {

namespace {

std::size_t count_non_finite(const Image& image) {
    return static_cast<std::size_t>(std::count_if(image.data.begin(), image.data.end(),
                                                  [](double v) { return !std::isfinite(v); }));
}

/// "2 values that are NaN or infinite, the first at (3, 4)".
std::string describe_non_finite(const Image& image, std::size_t count) {
    const auto bad = std::find_if(image.data.begin(), image.data.end(),
                                  [](double v) { return !std::isfinite(v); });
    const auto pixel = static_cast<std::size_t>(bad - image.data.begin()) /
                       static_cast<std::size_t>(image.channels);
    const auto width = static_cast<std::size_t>(image.width);
    return fmt::format("{} value{} NaN or infinite, the first at ({}, {})", count,
                       count == 1 ? " that is" : "s that are", pixel % width, pixel / width);
}

/// Whether the fourth channel, which has to be there, is 1 in every pixel.
bool is_opaque(const Image& image) {
    for (std::size_t i = 3; i < image.data.size(); i += static_cast<std::size_t>(image.channels))
        if (image.data[i] != 1) return false;
    return true;
}

/// Why the two cannot be measured against each other; empty when they can.
std::string why_not_comparable(const Image& a, const Image& b, const Comparison& found) {
    if (a.width != b.width || a.height != b.height) {
        return fmt::format("the sizes differ: {} x {} against {} x {}", a.width, a.height, b.width,
                           b.height);
    }
    if (a.width <= 0 || a.height <= 0 || a.color_channels() <= 0) return "the pictures are empty";
    if (compared_channels(a, b) == 0) {
        return fmt::format("the numbers of channels differ: {} against {}", a.color_channels(),
                           b.color_channels());
    }
    if (found.non_finite_a > 0) {
        return "the first picture has " + describe_non_finite(a, found.non_finite_a);
    }
    if (found.non_finite_b > 0) {
        return "the second picture has " + describe_non_finite(b, found.non_finite_b);
    }
    return {};
}

/// Mean, RMSE, PSNR and the maximum with its place.
void measure_values(const Image& a, const Image& b, Comparison& result) {
    double sum = 0;
    double sum_of_squares = 0;
    result.max = -1;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const double* va = a.pixel(x, y);
            const double* vb = b.pixel(x, y);
            for (int c = 0; c < result.channels; ++c) {
                const double difference = std::abs(va[c] - vb[c]);
                sum += difference;
                sum_of_squares += difference * difference;
                if (difference > result.max) {
                    result.max = difference;
                    result.max_x = x;
                    result.max_y = y;
                    result.max_channel = c;
                    result.max_a = va[c];
                    result.max_b = vb[c];
                }
            }
        }
    }
    const double values = static_cast<double>(result.pixels) * result.channels;
    result.mean = sum / values;
    result.rmse = std::sqrt(sum_of_squares / values);
    result.psnr = result.rmse > 0 ? -20.0 * elementary::log(result.rmse) / elementary::log(10.0)
                                  : std::numeric_limits<double>::infinity();
}

}  // namespace

int compared_channels(const Image& a, const Image& b) {
    const int channels_a = a.color_channels();
    const int channels_b = b.color_channels();
    if (channels_a == channels_b) return channels_a;
    const auto adds_nothing = [](const Image& image, int channels) {
        return image.color_channels() == channels + 1 && is_opaque(image);
    };
    if (channels_b == 3 && adds_nothing(a, channels_b)) return channels_b;
    if (channels_a == 3 && adds_nothing(b, channels_a)) return channels_a;
    return 0;
}

std::vector<double> pixel_differences(const Image& a, const Image& b) {
    assert(a.width == b.width && a.height == b.height);
    const int channels = compared_channels(a, b);
    assert(channels > 0);
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height));
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            double largest = 0;
            for (int c = 0; c < channels; ++c) {
                largest = std::max(largest, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
            }
            result.push_back(largest);
        }
    }
    return result;
}

double percentile(std::vector<double>& values, double share) {
    assert(!values.empty());
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    const auto index = std::min(static_cast<std::size_t>(std::max(rank, 1.0)), values.size()) - 1;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(index);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

Comparison compare_images(const Image& a, const Image& b, const CompareOptions& options) {
    Comparison result;
    result.width = a.width;
    result.height = a.height;
    result.channels = compared_channels(a, b);
    result.non_finite_a = count_non_finite(a);
    result.non_finite_b = count_non_finite(b);
    result.reason = why_not_comparable(a, b, result);
    result.comparable = result.reason.empty();
    if (!result.comparable) return result;

    result.pixels = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
    measure_values(a, b, result);

    std::vector<double> differences = pixel_differences(a, b);
    result.pixels_over = static_cast<std::size_t>(
        std::count_if(differences.begin(), differences.end(),
                      [&](double difference) { return difference > options.fail; }));
    result.over = static_cast<double>(result.pixels_over) / static_cast<double>(result.pixels);
    result.p99 = percentile(differences, 0.99);
    result.p999 = percentile(differences, 0.999);
    if (options.flip) result.flip = mean_flip(a, b);

    // In pixels, not in percent: 0.1 % of 1000 pixels must allow exactly one.
    const double allowed = options.fail_percent * static_cast<double>(result.pixels) / 100.0;
    result.pass = static_cast<double>(result.pixels_over) <= allowed;
    if (!result.pass) {
        result.reason =
            fmt::format("{} of {} pixels differ by more than {}, {} allowed", result.pixels_over,
                        result.pixels, options.fail, std::floor(allowed));
    }
    return result;
}

}  // namespace lancer::reference
