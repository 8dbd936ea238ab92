#include "cli/scene_size.h"

#include <algorithm>
#include <cmath>

namespace lancer::cli {

PictureSize size_or(const std::optional<PictureSize>& asked, const Scene& scene, int width) {
    if (asked) return *asked;
    const double height = std::round(width * static_cast<double>(scene.height) / scene.width);
    return {width, static_cast<int>(std::clamp(height, 1.0, 4096.0))};
}

}  // namespace lancer::cli
