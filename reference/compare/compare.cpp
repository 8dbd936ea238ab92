#include "reference/compare/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/elementary.h"
#include "reference/compare/flip.h"
#include "reference/compare/picture_edges.h"

namespace lancer::reference {

namespace {

std::size_t pixels_of(const Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// The indices of values of counted pixels that are NaN or infinite.
std::vector<std::size_t> non_finite_values(const Image& image, const PixelMask& counted) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        const std::size_t pixel = i / static_cast<std::size_t>(image.channels);
        if (!std::isfinite(image.data[i]) && counted.counts(pixel)) found.push_back(i);
    }
    return found;
}

/// "2 values that are NaN or infinite, the first at (3, 4)".
std::string describe_non_finite(const Image& image, const std::vector<std::size_t>& found) {
    const std::size_t pixel = found.front() / static_cast<std::size_t>(image.channels);
    const auto width = static_cast<std::size_t>(image.width);
    return fmt::format("{} value{} NaN or infinite, the first at ({}, {})", found.size(),
                       found.size() == 1 ? " that is" : "s that are", pixel % width, pixel / width);
}

/// Whether the fourth channel, which must exist, is 1 in every pixel.
bool is_opaque(const Image& image) {
    for (std::size_t i = 3; i < image.data.size(); i += static_cast<std::size_t>(image.channels))
        if (image.data[i] != 1) return false;
    return true;
}

/// Why the two pictures cannot be compared; empty when they can. Counts the values that are not
/// finite.
std::string why_not_comparable(const Image& a, const Image& b, const PixelMask& counted,
                               Comparison& found) {
    if (a.width != b.width || a.height != b.height) {
        return fmt::format("the sizes differ: {} x {} against {} x {}", a.width, a.height, b.width,
                           b.height);
    }
    if (a.width <= 0 || a.height <= 0 || a.color_channels() <= 0) return "the pictures are empty";
    if (!counted.flags.empty() && (counted.width != a.width || counted.height != a.height)) {
        return fmt::format("the mask has another size: {} x {}, and the pictures {} x {}",
                           counted.width, counted.height, a.width, a.height);
    }
    if (counted_pixels(counted, pixels_of(a)) == 0)
        return "the mask is black: no pixel is left to compare";
    const std::vector<std::size_t> bad_a = non_finite_values(a, counted);
    const std::vector<std::size_t> bad_b = non_finite_values(b, counted);
    found.non_finite_a = bad_a.size();
    found.non_finite_b = bad_b.size();
    if (compared_channels(a, b) == 0) {
        return fmt::format("the numbers of channels differ: {} against {}", a.color_channels(),
                           b.color_channels());
    }
    if (!bad_a.empty()) return "the first picture has " + describe_non_finite(a, bad_a);
    if (!bad_b.empty()) return "the second picture has " + describe_non_finite(b, bad_b);
    return {};
}

/// Measures mean, RMSE, PSNR and the maximum with its place.
void measure_values(const Image& a, const Image& b, const PixelMask& counted, Comparison& result) {
    double sum = 0;
    double sum_of_squares = 0;
    result.max = -1;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t pixel = a.index(x, y) / static_cast<std::size_t>(a.channels);
            if (!counted.counts(pixel)) continue;
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

/// The values of the pixels that are counted.
std::vector<double> counted_only(const std::vector<double>& values, const PixelMask& counted) {
    std::vector<double> kept;
    kept.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        if (counted.counts(i)) kept.push_back(values[i]);
    return kept;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Finds the pixels that are over and the window with most of them, and decides whether these are
/// too many.
void judge_pixels(const Image& a, const Image& b, const std::vector<double>& differences,
                  const CompareOptions& options, Comparison& result) {
    std::vector<std::uint8_t> against(differences.size());
    for (std::size_t i = 0; i < differences.size(); ++i) against[i] = differences[i] > options.fail;
    const auto number = [&] {
        return static_cast<std::size_t>(std::count(against.begin(), against.end(), 1));
    };
    result.pixels_over = number();
    result.over = static_cast<double>(result.pixels_over) / static_cast<double>(result.pixels);
    if (result.pixels_over > 0) {
        const auto moved = find_moved_edges(a, b, result.channels, options.fail);
        for (std::size_t i = 0; i < moved.size(); ++i) {
            if (against[i] == 0 || moved[i] == 0) continue;
            ++result.over_at_edges;
            if (options.edges_may_move) against[i] = 0;
        }
    }
    result.densest = densest_window(against, a.width, options.window);

    // Computed in pixels and not in percent: 0.1 % of 1000 pixels must allow exactly one.
    const double allowed = options.fail_percent * static_cast<double>(result.pixels) / 100.0;
    const char* apart = options.edges_may_move ? " away from edges" : "";
    if (static_cast<double>(number()) > allowed) {
        result.reason =
            fmt::format("{} of {} pixels differ by more than {}{}, {} allowed", number(),
                        result.pixels, options.fail, apart, std::floor(allowed));
    } else if (result.densest.share() * 100 > options.fail_window) {
        const Window& w = result.densest;
        result.reason = fmt::format(
            "{} of the {} x {} pixels from ({}, {}) on differ by more than {}{}, {:g} % allowed",
            w.flagged, w.width, w.height, w.x, w.y, options.fail, apart, options.fail_window);
    }
    result.pass = result.reason.empty();
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

std::vector<double> counted_differences(const Image& a, const Image& b, const PixelMask& counted) {
    std::vector<double> result = pixel_differences(a, b);
    for (std::size_t i = 0; i < result.size(); ++i)
        if (!counted.counts(i)) result[i] = 0;
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
    result.reason = why_not_comparable(a, b, options.counted, result);
    result.comparable = result.reason.empty();
    if (!result.comparable) return result;

    result.pixels = counted_pixels(options.counted, pixels_of(a));
    result.left_out = pixels_of(a) - result.pixels;
    measure_values(a, b, options.counted, result);
    const std::vector<double> differences = counted_differences(a, b, options.counted);
    std::vector<double> sorted = counted_only(differences, options.counted);
    result.p99 = percentile(sorted, 0.99);
    result.p999 = percentile(sorted, 0.999);
    if (options.flip) {
        const std::vector<double> errors =
            options.counted.flags.empty()
                ? flip_errors(a, b)
                : flip_errors(blacked_out(a, options.counted), blacked_out(b, options.counted));
        result.flip = mean_of(counted_only(errors, options.counted));
    }
    judge_pixels(a, b, differences, options, result);
    return result;
}

}  // namespace lancer::reference
