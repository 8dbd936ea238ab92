// How wrong a picture is, measured by rays that never enter it.
//
// For a pixel of any value m and two independent unbiased estimates y1, y2 of its true value mu,
// the product (m - y1)(m - y2) has the mean (m - mu)^2: an estimate of the squared error that no
// choice made on the way to m can spoil. Pixels are drawn with probabilities that follow the
// predicted errors, and each counts by the inverse of its own.
// Adaptive sampling spoils estimates from its own samples: Kirk and Arvo, "Unbiased sampling
// techniques for image synthesis", SIGGRAPH 1991. Systematic draws and their weights: Cochran,
// "Sampling Techniques", 3rd ed. 1977, ch. 8 and 9A.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "accuracy/draw_shares.h"
#include "accuracy/picture_samples.h"

namespace lancer::accuracy {

/// What the picture is judged by: a renderer and limits that cut nothing which matters.
struct Truth {
    const Renderer& renderer;
    TraceLimits limits;
};

/// Points of each estimate y1, y2, or as many as the pixel has samples if these are more. Few find
/// the error of a smooth picture by half of the rays; thin wires are missed by most estimates then,
/// so that few draws carry the result.
inline constexpr std::uint32_t few_points = 8;
inline constexpr std::uint32_t many_points = 16;

struct AuditPlan {
    int draws = 1000;
    /// Audits of different numbers are independent of each other and of the picture.
    std::uint64_t number = 0;
    DrawShares shares = first_shares;
    std::uint32_t points = many_points;
};

/// A pixel of the whole picture, and its share of something.
struct PixelShare {
    int x = 0;
    int y = 0;
    double share = 0;
};

struct Audit {
    /// One a draw; each has the picture's mean squared error (over pixels and channels) as its
    /// mean.
    std::vector<double> terms;
    std::vector<double> terms_of_few;  ///< as they are with the first few_points of each estimate
    std::vector<std::size_t> pixels;   ///< that were drawn, index into PictureSamples::pixels()
    std::vector<SeenDraw> seen;        ///< for best_shares()
    RayCounts rays;
    std::uint64_t points = 0;  ///< of all estimates
    std::uint64_t points_of_few = 0;

    /// Draws of another audit of the same samples, by the same plan but for its number.
    void add(const Audit& other);
};

/// \param predicted  squared errors to draw by, one a pixel; see Prediction::errors
Audit audit(const Truth& truth, const PictureSamples& samples, std::span<const double> predicted,
            const AuditPlan& plan, const Progress& progress);

/// An error is told when this many equal draws would tell as much as those of an audit ...
inline constexpr double least_effective_draws = 60;
/// ... and when they tell the logarithm of a mean square this well: half the interval's width is
/// then 12 %.
inline constexpr double told_log_error = 0.125;

/// A root mean squared error with its interval of 95 %.
struct ErrorEstimate {
    double mean_square = 0;     ///< may be negative by chance
    double standard_error = 0;  ///< of mean_square
    double rmse = 0;            ///< 0 when mean_square is not positive
    double low = 0;
    double high = 0;
    double effective_draws = 0;  ///< as many equal ones would tell as much
    bool all_zero = false;       ///< no draw found a difference beyond rounding

    /// Half the interval's width, as a share of rmse.
    double half_width() const { return rmse > 0 ? (high - low) / 2 / rmse : 0; }
    /// Standard error of the logarithm of mean_square.
    double log_error() const { return mean_square > 0 ? standard_error / mean_square : 0; }
};

/// Terms of an audit, summed: all that an estimate takes from them.
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
    bool are_zero() const;  ///< but for rounding
};

/// An audit of some of the picture's pixels, with the earlier one of them.
struct Stratum {
    double weight = 1;  ///< its share of the pixels
    TermSums terms;
    TermSums earlier;  ///< may be empty
};

/// The interval is exp(+-1.96 S/T) around the mean square T with standard error S.
ErrorEstimate estimate(std::span<const double> terms);

/// The mean square of `terms` with an interval as wide, for their number, as they and `earlier`
/// ones of the same distribution say together. Where few draws carry the sum, low sums come with
/// little spread; those of others do not know that these are low.
ErrorEstimate estimate(std::span<const double> terms, std::span<const double> earlier);

/// The same for audits that were drawn apart, each from pixels of its own: the mean over all pixels
/// is that of the strata's, weighted by their numbers of pixels, and as their draws are
/// independent, so is the variance, by the weights' squares. Cochran, ch. 5.
ErrorEstimate estimate_of_strata(std::span<const Stratum> strata);

/// The pixels that `audit` owes most of its result to, largest first, with their shares of the sum
/// of squared terms.
std::vector<PixelShare> dominant_pixels(const Audit& audit, const PictureSamples& samples,
                                        std::size_t most);

}  // namespace lancer::accuracy
