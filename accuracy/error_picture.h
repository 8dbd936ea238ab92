// A finished picture and the report on its error.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "accuracy/audit.h"
#include "accuracy/error_sums.h"
#include "accuracy/off_audit.h"
#include "accuracy/prediction.h"

namespace lancer::accuracy {

/// The share of pixels that are off by more than `steps`, where such a share was asked for.
struct OffReport {
    double asked = 0;      ///< share of the pixels
    double steps = 0;      ///< threshold in steps of 8 bits
    OffEstimate estimate;  ///< from the audit that is printed
    double predicted = 0;  ///< share, predicted from the picture's own samples
};

/// A predicted error below this share of the error asked for counts as none. It is far below the
/// error at which refining stops, and far above rounding.
inline constexpr double nearly_none = 0.1;

struct ErrorReport {
    double asked = 0;  ///< RMSE; 0 where a time, a number of passes or a share was asked for
    std::optional<OffReport> off;  ///< set where a share of pixels was asked for
    int passes = 0;  ///< that were made, where a time or a number of passes was asked for
    bool audited = false;
    /// The deciding audits say that the printed audit is reliable. The printed audit has no say:
    /// if it were printed only when low, the printed intervals would be too low.
    bool is_told = false;
    ErrorEstimate error;               ///< from the audit that is printed; empty without one
    double effective_draws = 0;        ///< of the last deciding audit
    bool rare_light = false;           ///< the specks that were met forbid a told error
    std::vector<PixelShare> dominant;  ///< pixels where that audit found most, or those specks
    double predicted = 0;              ///< RMSE, predicted from the picture's own samples
    TraceLimits limits;                ///< that the picture was made with
    double rays_per_pixel = 0;         ///< camera rays
    double even_rays_per_pixel = 0;  ///< predicted for the same error, with equally many everywhere
    RayCounts picture;               ///< rays that entered the picture
    RayCounts deciding;              ///< rays that chose limits, and rays of the deciding audits
    RayCounts printed;               ///< rays of the audit that is printed

    /// No draw found a difference, and the prediction is nearly none as well.
    bool is_flat() const;
    /// Whether the error is told and below the one asked for, or the picture is flat. Without an
    /// audit the prediction decides. True when no error was asked for.
    bool is_reached() const;
};

struct ErrorPicture {
    Image image;
    ErrorReport report;
    ErrorSums sums;                     ///< from which the report is made
    std::vector<double> errors;         ///< predicted standard error per pixel, RMS over channels
    std::vector<std::uint32_t> counts;  ///< samples per pixel
};

/// Makes the picture from the samples, and completes the report and the sums from them.
///
/// \param sums  has the draws, where there are any
ErrorPicture finished(const PictureSamples& samples, const Prediction& prediction,
                      ErrorReport report, ErrorSums sums = {});

}  // namespace lancer::accuracy
