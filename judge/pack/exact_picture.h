// A picture with a known error: rendered in double and in extended precision.
#pragma once

#include <string>
#include <vector>

#include "judge/pack/scene_json.h"
#include "model/image.h"

namespace lancer::judge {

/// The channels of Renderer::render() with `aov`, in extended precision, which rounds 2,048 times
/// more finely. So the distance to the double picture bounds the error of double, and is larger
/// than the error of extended precision.
struct ExactPicture {
    Image image;
    /// per pixel: the two number types meet different objects
    std::vector<std::uint8_t> is_undecided;
    // The largest distance between the two over all other pixels.
    double color_error = 0;
    double depth_error = 0;  ///< relative
    double normal_error = 0;
};

ExactPicture exact_picture(const Scene& scene, const View& view);

/// Values of the rays of chosen pixels, each with its error: `count` of them, or as many as there
/// are. If `count` allows it, every visible object has at least one.
Json exact_probes(const Scene& scene, const View& view, const ExactPicture& picture,
                  std::size_t count);

}  // namespace lancer::judge
