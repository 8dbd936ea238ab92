// Measures the error of a picture against the truth.
#pragma once

#include "judge/tradeoff/true_picture.h"

namespace lancer::judge {

struct MeasuredError {
    double mean_square = 0;     ///< over pixels and channels, linear light; unbiased
    double standard_error = 0;  ///< of mean_square, caused by the noise of the truth
    double rmse = 0;            ///< 0 when mean_square is not positive
    double low = 0;             ///< the interval of 95 %
    double high = 0;
    double p999 = 0;  ///< 99.9 % of the pixels have at most this error in their worst channel
    double flip = 0;  ///< mean FLIP error

    /// Whether the truth is precise enough to distinguish this error from zero.
    bool is_told() const { return low > 0 || high == 0; }
    /// The error to use in comparisons: its upper bound when it is not told.
    double counted() const { return is_told() ? rmse : high; }
};

/// `picture` must have the size of the truth.
MeasuredError error_of(const Image& picture, const TruePicture& truth);

/// The mean squared difference of two pictures of one size, over pixels and channels.
double mean_square_between(const Image& a, const Image& b);

}  // namespace lancer::judge
