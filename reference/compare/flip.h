// FLIP: how visible a difference is to a viewer who alternates between the two pictures.
//
// P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild: "FLIP: A
// Difference Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and
// Interactive Techniques 3(2), 2020. This is the variant for low dynamic range (LDR-FLIP).
//
// P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild: "FLIP: A
// Difference Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and
// Interactive Techniques 3(2), 2020. The variant for pictures of ordinary range (LDR-FLIP).
#pragma once

#include <vector>

#include "model/image.h"

namespace lancer::reference {

/// The paper's viewing conditions: 0.7 m from a screen 0.7 m wide with 3840 pixels.
inline constexpr double default_pixels_per_degree = 67.020643276582256;

/// The error of each pixel, rows from the top, from 0 (invisible) to 1. `reference` and `test` hold
/// linear light and must have the same size; values are clamped to 0..1. If a picture has fewer
/// than three channels, the first is taken as grey. Alpha and extra channels are ignored.
std::vector<double> flip_errors(const Image& reference, const Image& test,
                                double pixels_per_degree = default_pixels_per_degree);

/// The mean of flip_errors(): the paper's first pooled value.
double mean_flip(const Image& reference, const Image& test,
                 double pixels_per_degree = default_pixels_per_degree);

}  // namespace lancer::reference
