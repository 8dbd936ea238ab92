#include "judge/tradeoff/measured_error.h"

#include <algorithm>
#include <cmath>

#include "reference/compare/compare.h"

namespace lancer::judge {
namespace {

constexpr double two_sided_95 = 1.96;

Color color_at(const Image& image, std::size_t pixel) {
    const double* value = image.data.data() + pixel * static_cast<std::size_t>(image.channels);
    return {value[0], value[1], value[2]};
}

}  // namespace

MeasuredError error_of(const Image& picture, const TruePicture& truth) {
    MeasuredError e;
    double sum = 0;
    double variance = 0;
    for (std::size_t pixel = 0; pixel < truth.pixels(); ++pixel) {
        const Color m = color_at(picture, pixel);
        const Color a = m - truth.half(0, pixel);
        const Color b = m - truth.half(1, pixel);
        sum += dot(a, b);
        // Let x = m minus the halves' mean, and d their difference. The mean of (x d)^2 is the
        // variance of this pixel's product: for normally distributed halves, x and d are
        // independent.
        const double xd = dot((a + b) / 2.0, b - a);
        variance += xd * xd;
    }
    const double values = 3 * static_cast<double>(truth.pixels());
    e.mean_square = sum / values;
    e.standard_error = std::sqrt(variance) / values;
    e.rmse = std::sqrt(std::max(0.0, e.mean_square));
    e.low = std::sqrt(std::max(0.0, e.mean_square - two_sided_95 * e.standard_error));
    e.high = std::sqrt(std::max(0.0, e.mean_square + two_sided_95 * e.standard_error));
    const reference::Comparison c = reference::compare_images(picture, truth.image(), {});
    e.p999 = c.p999;
    e.flip = c.flip;
    return e;
}

double mean_square_between(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i)
        sum += (a.data[i] - b.data[i]) * (a.data[i] - b.data[i]);
    return a.data.empty() ? 0 : sum / static_cast<double>(a.data.size());
}

}  // namespace lancer::judge
