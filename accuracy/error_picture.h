// A finished picture with what is known of its error.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "accuracy/audit.h"
#include "accuracy/error_sums.h"
#include "accuracy/off_audit.h"
#include "accuracy/prediction.h"

namespace lancer::accuracy {

/// Pixels that are off by more than so much, where a share of them was asked for.
struct OffReport {
    double asked = 0;      ///< share of the pixels
    double steps = 0;      ///< of 8 bits
    OffEstimate estimate;  ///< of the audit that is printed
    double predicted = 0;  ///< share, from the picture's own samples
};

/// Of what was asked for: far below where refining stops, and far above rounding.
inline constexpr double nearly_none = 0.1;

struct ErrorReport {
    double asked = 0;  ///< 0: no error, but a time, a number of passes or a share of pixels off
    std::optional<OffReport> off;  ///< in place of what is told of the RMSE
    int passes = 0;                ///< then: how many were made
    bool audited = false;
    /// Earlier audits say that one that is printed can be relied on. They alone decide it: were
    /// low draws printed and high ones refused, intervals would be too low.
    bool is_told = false;
    ErrorEstimate error;               ///< of the audit that is printed; without one, nothing
    double effective_draws = 0;        ///< of the last audit that decided
    bool rare_light = false;           ///< specks were met that speak of others: nothing is told
    std::vector<PixelShare> dominant;  ///< where that audit found most, or those specks
    double predicted = 0;              ///< RMSE, from the picture's own samples
    TraceLimits limits;                ///< that the picture was made with
    double rays_per_pixel = 0;         ///< through the image plane
    double even_rays_per_pixel = 0;    ///< predicted: as many everywhere for the same error
    RayCounts picture;                 ///< rays that entered the picture
    RayCounts deciding;                ///< rays that chose limits or decided on going on
    RayCounts printed;                 ///< rays of the audit that is printed

    /// No draw found any difference, and the picture's own samples know of none either.
    bool is_flat() const;
    /// Told, and below what was asked; or flat. Without an audit, predicted so. True when nothing
    /// was asked for.
    bool is_reached() const;
};

struct ErrorPicture {
    Image image;
    ErrorReport report;
    ErrorSums sums;                     ///< what the report rests on
    std::vector<double> errors;         ///< standard error per pixel, RMS over channels: a guess
    std::vector<std::uint32_t> counts;  ///< samples per pixel
};

/// The picture that the samples make; fills in what the report says of them.
///
/// \param sums  has the draws, where there are any
ErrorPicture finished(const PictureSamples& samples, const Prediction& prediction,
                      ErrorReport report, ErrorSums sums = {});

}  // namespace lancer::accuracy
