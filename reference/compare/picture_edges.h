// Edges told from two pictures alone, without the scene: where another program's sampling may move
// a silhouette by a pixel's width and must not touch what is shaded.
#pragma once

#include <cstdint>
#include <vector>

#include "model/image.h"

namespace lancer::reference {

/// A step must be at least so high, in linear light, ...
inline constexpr double least_step = 0.02;
/// ... and so many times higher than the picture's changes on both its sides, to be an edge and not
/// a slope.
inline constexpr double step_against_slopes = 4;

/// One flag per pixel of `image`, rows from the top: a step lies between it and a neighbour. A step
/// may take one pixel, or two where the edge is smoothed.
std::vector<std::uint8_t> find_picture_edges(const Image& image, int channels);

/// Flags the pixels at which the two pictures may differ by an edge that lies a pixel's width
/// elsewhere: one of them has an edge there, and each picture's value lies, channel by channel,
/// within what the other has in the 3 x 3 pixels around, give or take `tolerance`. A difference in
/// shading is none of these where shading is all there is. The sizes must be equal.
std::vector<std::uint8_t> find_moved_edges(const Image& a, const Image& b, int channels,
                                           double tolerance);

}  // namespace lancer::reference
