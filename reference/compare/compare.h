// Compares two pictures of the same scene: how much they differ, where, and whether that is too
// much.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/image.h"
#include "reference/compare/densest_window.h"
#include "reference/compare/mask.h"

namespace lancer::reference {

/// When a comparison fails, and what to compute.
struct CompareOptions {
    /// A pixel is over when its difference (see pixel_differences) is greater than this, in linear
    /// light.
    double fail = 0;
    /// The comparison fails when more than this percentage of the pixels is over.
    double fail_percent = 0;
    bool flip = true;  ///< also compute the FLIP metric, by far the slowest
    /// Only these pixels count, in all measures.
    PixelMask counted{};
    /// Pixels that are over because an edge is displaced by up to a pixel's width
    /// (find_moved_edges) do not make the comparison fail.
    bool edges_may_move = false;
    int window = 16;  ///< side of the search window in pixels, at least 1
    /// The comparison fails when more than this percentage of the pixels of some window is over.
    double fail_window = 100;
};

/// The result of compare_images. All differences are absolute, in linear light.
struct Comparison {
    bool pass = false;
    /// Why it failed, one sentence without a full stop; empty when it passed.
    std::string reason;
    /// False when nothing can be measured: sizes or channels differ, or a value is NaN or infinite.
    /// Then the comparison failed, and the numbers below the line are meaningless.
    bool comparable = false;
    std::size_t non_finite_a = 0;  ///< values of the first picture that are NaN or infinite
    std::size_t non_finite_b = 0;

    /// The curves by which the two files were decoded (io::curve_of), set by the caller that read
    /// them. If they differ, equal numbers in the two files are different values.
    std::string curve_a;
    std::string curve_b;

    // ----
    int width = 0;
    int height = 0;
    int channels = 0;        ///< compared ones: colour and alpha, not the extra channels of an EXR
    std::size_t pixels = 0;  ///< compared ones
    std::size_t left_out = 0;  ///< by the mask
    double mean = 0;           ///< of |a - b| over all values of all channels
    double rmse = 0;           ///< over all values of all channels
    double psnr = 0;           ///< 20 log10(1 / rmse), decibels; infinite for equal pictures
    double max = 0;            ///< of |a - b| over all values
    int max_x = 0;             ///< its pixel, from the top left corner
    int max_y = 0;
    int max_channel = 0;
    double max_a = 0;  ///< the two values there
    double max_b = 0;
    double p99 = 0;   ///< 99 % of the pixels differ by this or less (nearest rank)
    double p999 = 0;  ///< 99.9 % of the pixels
    std::size_t pixels_over = 0;
    double over = 0;  ///< share of the pixels over CompareOptions::fail, 0..1
    /// How many of pixels_over an edge explains, see picture_edges.h. They count for the verdict
    /// unless CompareOptions::edges_may_move is set.
    std::size_t over_at_edges = 0;
    Window densest;   ///< with most of the pixels that count against the verdict
    double flip = 0;  ///< mean FLIP error, 0..1, see flip.h; 0 when not asked for
};

/// The number of channels that are compared: all but the named extra ones. An alpha that only one
/// of the pictures has is ignored if it is 1 everywhere. 0 when the channels differ.
int compared_channels(const Image& a, const Image& b);

/// Per pixel, rows from the top: the largest of the absolute differences of its channels. Both
/// pictures must have the same size and compared_channels().
std::vector<double> pixel_differences(const Image& a, const Image& b);

/// The same, with 0 for pixels that are not in `counted`.
std::vector<double> counted_differences(const Image& a, const Image& b, const PixelMask& counted);

/// The smallest value for which at least the share `share` (0..1] of the values is not larger.
/// Reorders `values`, which must not be empty.
double percentile(std::vector<double>& values, double share);

/// Measures `a` against `b`. Does not throw for any content of the pictures: if they cannot be
/// compared, the comparison fails.
Comparison compare_images(const Image& a, const Image& b, const CompareOptions& options);

}  // namespace lancer::reference
