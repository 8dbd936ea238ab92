// Finds edges from two pictures alone, without the scene. Another program's sampling may move a
// silhouette by a pixel's width, but must not change shading.
#pragma once

#include <cstdint>
#include <vector>

#include "model/image.h"

namespace lancer::reference {

/// To be an edge, a step must be at least this high, in linear light, ...
inline constexpr double least_step = 0.02;
/// ... and this many times higher than the picture's changes on both sides; otherwise it is a
/// slope.
inline constexpr double step_against_slopes = 4;

/// One flag per pixel of `image`, rows from the top: there is a step between the pixel and a
/// neighbour. A step spans one pixel, or two where the edge is smoothed.
std::vector<std::uint8_t> find_picture_edges(const Image& image, int channels);

/// Flags the pixels whose difference a displaced edge can explain: one of the pictures has an edge
/// there, and each picture's value lies, channel by channel, within the range of the other picture
/// in the 3 x 3 pixels around, extended by `tolerance`. A difference in shading away from edges is
/// not flagged. The sizes must be equal.
std::vector<std::uint8_t> find_moved_edges(const Image& a, const Image& b, int channels,
                                           double tolerance);

}  // namespace lancer::reference
