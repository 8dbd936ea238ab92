// An audit measures the error of a picture by rays that never enter it.
//
// Let a pixel have the value m and the true value mu, and let y1, y2 be two independent unbiased
// estimates of mu. The product (m - y1)(m - y2) has the mean (m - mu)^2. It stays unbiased
// however m was made, because m does not depend on y1 and y2. Estimates from a picture's own
// samples are biased when sampling is adaptive: Kirk and Arvo, "Unbiased sampling techniques for
// image synthesis", SIGGRAPH 1991.
// An audit draws pixels with probabilities that follow the predicted errors, and weights each draw
// by the inverse of its probability. Systematic sampling and its weights: Cochran, "Sampling
// Techniques", 3rd ed. 1977, ch. 8 and 9A.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "accuracy/draw_shares.h"
#include "accuracy/picture_samples.h"

namespace lancer::accuracy {

/// The picture's error is measured against this renderer with limits that cut nothing visible.
struct Truth {
    const Renderer& renderer;
    TraceLimits limits;
};

struct AuditPlan {
    int draws = 1000;
    /// Audits of different numbers are independent of each other and of the picture.
    std::uint64_t number = 0;
    DrawShares shares = first_shares;
};

/// A pixel, by its place in the whole picture, with its share of a sum.
struct PixelShare {
    int x = 0;
    int y = 0;
    double share = 0;
};

struct Audit {
    /// One term per draw. The mean of each is the picture's mean squared error, over pixels and
    /// channels.
    std::vector<double> terms;
    std::vector<std::size_t> pixels;  ///< that were drawn, index into PictureSamples::pixels()
    std::vector<SeenDraw> seen;       ///< for best_shares()
    RayCounts rays;

    /// Appends the draws of another audit of the same samples, with the same shares.
    void add(const Audit& other);
};

/// \param predicted  squared errors to draw by, one a pixel; see Prediction::errors
Audit audit(const Truth& truth, const PictureSamples& samples, std::span<const double> predicted,
            const AuditPlan& plan, const Progress& progress);

/// An error is told only when an audit has at least this many effective draws ...
inline constexpr double least_effective_draws = 60;
/// ... and when the logarithm of the mean square has at most this standard error. Half the
/// interval's width is then 12 % of the RMSE.
inline constexpr double told_log_error = 0.125;

/// A root mean squared error with its 95 % confidence interval.
struct ErrorEstimate {
    double mean_square = 0;     ///< unbiased, so it may be negative by chance
    double standard_error = 0;  ///< of mean_square
    double rmse = 0;            ///< 0 when mean_square is not positive
    double low = 0;
    double high = 0;
    double effective_draws = 0;  ///< (sum of terms)^2 / (sum of their squares)
    bool all_zero = false;       ///< no draw found a difference beyond rounding

    /// Half the interval's width, as a share of rmse.
    double half_width() const { return rmse > 0 ? (high - low) / 2 / rmse : 0; }
    /// Standard error of the logarithm of mean_square.
    double log_error() const { return mean_square > 0 ? standard_error / mean_square : 0; }
};

/// Sums over the terms of an audit. An estimate needs nothing else of them.
struct TermSums {
    double count = 0;
    double sum = 0;
    double squares = 0;

    TermSums() = default;
    explicit TermSums(std::span<const double> terms) { add(terms); }
    void add(std::span<const double> terms);
    void add(const TermSums& others);
    double mean() const { return sum / count; }
    double variance() const;
    bool are_zero() const;  ///< up to rounding
};

/// An audit of some of the picture's pixels, and an earlier audit of the same pixels.
struct Stratum {
    double weight = 1;  ///< these pixels' share of the picture's pixels
    TermSums terms;
    TermSums earlier;  ///< may be empty
};

/// The mean square T of `terms` with standard error S. Its interval is T exp(+-1.96 S/T).
ErrorEstimate estimate(std::span<const double> terms);

/// The mean square of `terms`. The relative variance is that of `terms` and `earlier` together, or
/// that of `terms` alone if it is larger; `earlier` has the same distribution. Reason: where a few
/// draws carry most of the sum, a low sum comes with a low variance, and the interval would be too
/// narrow. The variance of other draws does not depend on whether this sum is low.
ErrorEstimate estimate(std::span<const double> terms, std::span<const double> earlier);

/// The same for independent audits, each of pixels of its own (strata). The mean square is the sum
/// of weight times the stratum's mean square. The draws of different strata are independent, so the
/// variance is the sum of weight^2 times the stratum's variance. Cochran, ch. 5.
ErrorEstimate estimate_of_strata(std::span<const Stratum> strata);

/// The pixels that `audit` owes most of its result to, largest first, with their shares of the sum
/// of squared terms.
std::vector<PixelShare> dominant_pixels(const Audit& audit, const PictureSamples& samples,
                                        std::size_t most);

}  // namespace lancer::accuracy
