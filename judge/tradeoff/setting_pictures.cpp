#include "judge/tradeoff/setting_pictures.h"

#include <algorithm>
#include <cmath>

#include "judge/report/report.h"
#include "reference/compare/color_map.h"
#include "reference/compare/compare.h"
#include "reference/compare/heat_map.h"

namespace lancer::judge {
namespace {

constexpr std::size_t most_bytes = 100'000;  // of one picture

Image samples_image(const SettingRun& run) {
    Image image(run.image.width, run.image.height);
    const double most = std::log2(1.0 + *std::max_element(run.samples.begin(), run.samples.end()));
    for (std::size_t pixel = 0; pixel < run.samples.size(); ++pixel) {
        const Color color = reference::magma(std::log2(1.0 + run.samples[pixel]) / most);
        for (int c = 0; c < 3; ++c) image.data[pixel * 3 + static_cast<std::size_t>(c)] = color[c];
    }
    return image;
}

}  // namespace

SettingPictures pictures_of(const SettingRun& run, const TruePicture& truth) {
    SettingPictures pictures;
    pictures.picture = preview_of(run.image, most_bytes).png;
    const auto map_of = [&](const std::vector<double>& errors) {
        return preview_of(reference::heat_map(errors, run.image.width, false), most_bytes).png;
    };
    pictures.error = map_of(reference::pixel_differences(run.image, truth.image()));
    if (!run.guessed.empty()) pictures.guessed = map_of(run.guessed);
    if (!run.samples.empty()) pictures.samples = preview_of(samples_image(run), most_bytes).png;
    return pictures;
}

}  // namespace lancer::judge
