// A picture whose error is known: made twice, in double precision and in extended.
#pragma once

#include <string>
#include <vector>

#include "judge/pack/scene_json.h"
#include "model/image.h"

namespace lancer::judge {

/// The channels of Renderer::render with `aov`, in extended precision, whose rounding is 2,048
/// times finer: so its distance to double precision is how far double is off, and more than its own
/// error.
struct ExactPicture {
    Image image;
    std::vector<std::uint8_t> is_undecided;  ///< per pixel: the two number types see other things
    // The largest distance between the two in the other pixels.
    double color_error = 0;
    double depth_error = 0;  ///< relative
    double normal_error = 0;
};

ExactPicture exact_picture(const Scene& scene, const View& view);

/// Values of chosen pixels' rays, each with its error: as many as asked for, or as there are.
/// Every object that is seen has one at least, where there are enough.
Json exact_probes(const Scene& scene, const View& view, const ExactPicture& picture,
                  std::size_t count);

}  // namespace lancer::judge
