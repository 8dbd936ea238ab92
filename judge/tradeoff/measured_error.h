// How wrong a picture is, by a true one.
#pragma once

#include "judge/tradeoff/true_picture.h"

namespace lancer::judge {

struct MeasuredError {
    double mean_square = 0;     ///< over pixels and channels, linear light; without bias
    double standard_error = 0;  ///< of mean_square, as far as the truth's own noise makes it
    double rmse = 0;            ///< 0 when mean_square is not positive
    double low = 0;             ///< the interval of 95 %
    double high = 0;
    double p999 = 0;  ///< 99.9 % of the pixels are off by this or less, in their worst channel
    double flip = 0;  ///< mean FLIP error

    /// Whether the truth is good enough to tell this error from none.
    bool is_told() const { return low > 0 || high == 0; }
    /// What to count on: the error, or as large as it may be where it is not told.
    double counted() const { return is_told() ? rmse : high; }
};

/// `picture` must have the truth's size.
MeasuredError error_of(const Image& picture, const TruePicture& truth);

/// The mean squared difference of two pictures of one size, over pixels and channels.
double mean_square_between(const Image& a, const Image& b);

}  // namespace lancer::judge
