#include "accuracy/error_picture.h"

#include <cmath>
#include <utility>

#include "accuracy/joined_report.h"

namespace lancer::accuracy {

bool ErrorReport::is_flat() const {
    return audited && error.all_zero && !rare_light && predicted <= nearly_none * asked;
}

bool ErrorReport::is_reached() const {
    if (off) return (audited ? off->estimate.high : off->predicted) <= off->asked;
    if (asked == 0) return true;
    if (!audited) return predicted <= asked;
    return !rare_light && (is_flat() || (is_told && error.high <= asked));
}

ErrorPicture finished(const PictureSamples& samples, const Prediction& prediction,
                      ErrorReport report, ErrorSums sums) {
    ErrorPicture picture;
    picture.image = samples.image();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::uint32_t n = samples.pixels()[i].count;
        picture.counts.push_back(n);
        picture.errors.push_back(std::sqrt(prediction.of(i, n) / 3));
        sums.predicted += prediction.of(i, n);
        sums.scores += prediction.of(i, 1);
    }
    sums.pixels = static_cast<double>(samples.size());
    sums.asked = report.asked;
    sums.audited = report.audited;
    sums.rare_light = report.rare_light;
    sums.dominant = report.dominant;
    sums.picture = samples.rays();
    sums.deciding_rays = report.deciding;
    sums.printed_rays = report.printed;
    tell_costs(report, {&sums, 1});
    picture.report = std::move(report);
    picture.sums = std::move(sums);
    return picture;
}

}  // namespace lancer::accuracy
