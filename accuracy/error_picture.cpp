#include "accuracy/error_picture.h"

#include <cmath>
#include <utility>

#include "model/elementary.h"

namespace lancer::accuracy {

bool ErrorReport::is_flat() const {
    constexpr double nearly_none = 0.1;  // far below where refining stops, far above rounding
    return audited && error.all_zero && !rare_light && predicted <= nearly_none * asked;
}

bool ErrorReport::is_reached() const {
    if (off) return (audited ? off->estimate.high : off->predicted) <= off->asked;
    if (asked == 0) return true;
    if (!audited) return predicted <= asked;
    return !rare_light && (is_flat() || (is_told && error.high <= asked));
}

ErrorPicture finished(const Samples& samples, const Prediction& prediction, ErrorReport report) {
    ErrorPicture picture;
    picture.image = samples.image();
    const double mean_square = prediction.mean_square(samples);
    double scores = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::uint32_t n = samples.pixels()[i].count;
        picture.counts.push_back(n);
        picture.errors.push_back(std::sqrt(prediction.of(i, n) / 3));
        scores += prediction.of(i, 1);
    }
    const double pixels = static_cast<double>(samples.size());
    report.predicted = std::sqrt(mean_square);
    report.picture = samples.rays();
    report.rays_per_pixel = static_cast<double>(report.picture.primary) / pixels;
    if (mean_square > 0)
        report.even_rays_per_pixel = elementary::pow(scores / (3 * pixels * mean_square), 2.0 / 3);
    picture.report = std::move(report);
    return picture;
}

}  // namespace lancer::accuracy
