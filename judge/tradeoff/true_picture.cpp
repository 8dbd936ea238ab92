#include "judge/tradeoff/true_picture.h"

#include <bit>
#include <cmath>

#include "model/sobol.h"

namespace lancer::judge {
namespace {

constexpr std::size_t batch_size = std::size_t(1) << 17;  // rays: enough for all cores

// Above the streams of pictures and of audits.
constexpr std::uint64_t first_half_stream = std::uint64_t(5) << 61;

void put(std::string& out, std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) out += static_cast<char>(value >> (8 * byte) & 255);
}

std::uint64_t number_at(std::string_view bytes, std::size_t at) {
    std::uint64_t value = 0;
    for (int byte = 7; byte >= 0; --byte)
        value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(byte)]);
    return value;
}

}  // namespace

Scene with_true_surfaces(Scene scene) {
    scene.settings.tolerance = std::nullopt;
    for (Patch& patch : scene.patches) patch.tolerance = std::nullopt;
    for (Lathe& lathe : scene.lathes) lathe.tolerance = std::nullopt;
    for (Prism& prism : scene.prisms) prism.tolerance = std::nullopt;
    return scene;
}

TruePicture::TruePicture(const View& view, const TraceLimits& limits, std::uint64_t seed)
    : view_(view),
      limits_(limits),
      seed_(seed),
      part_(view.crop.value_or(Crop{0, 0, view.width, view.height})) {
    const auto size =
        static_cast<std::size_t>(part_.width) * static_cast<std::size_t>(part_.height);
    for (std::vector<Color>& sums : sums_) sums.assign(size, Color{0, 0, 0});
}

void TruePicture::refine(const Renderer& renderer, std::uint32_t points, const Progress& progress) {
    if (points <= points_) return;
    const std::uint32_t more = points - points_;
    const std::size_t per_batch = std::max<std::size_t>(1, batch_size / more);
    std::vector<PicturePoint> batch;
    std::vector<Color> colors;
    RayCounts uncounted;
    for (const unsigned which : {0U, 1U}) {
        std::vector<Color>& sums = sums_[which];
        for (std::size_t first = 0; first < sums.size(); first += per_batch) {
            const std::size_t end = std::min(sums.size(), first + per_batch);
            batch.clear();
            for (std::size_t pixel = first; pixel < end; ++pixel) {
                const auto width = static_cast<std::size_t>(part_.width);
                const int x = part_.x + static_cast<int>(pixel % width);
                const int y = part_.y + static_cast<int>(pixel / width);
                const SobolPoints sequence(pixel_key(seed_, x, y, first_half_stream + which));
                for (std::uint32_t i = points_; i < points; ++i)
                    batch.push_back({x + sequence[i].x, y + sequence[i].y});
            }
            colors.resize(batch.size());
            renderer.trace(view_, batch, limits_, colors, {}, uncounted);
            for (std::size_t i = 0; i < colors.size(); ++i) sums[first + i / more] += colors[i];
            if (progress)
                progress((which + static_cast<double>(end) / static_cast<double>(sums.size())) / 2);
        }
    }
    points_ = points;
}

std::vector<PicturePoint> TruePicture::first_points(int x, int y) const {
    const SobolPoints sequence(pixel_key(seed_, x, y, first_half_stream));
    std::vector<PicturePoint> points;
    for (std::uint32_t i = 0; i < std::min(points_, 64U); ++i)
        points.push_back({x + sequence[i].x, y + sequence[i].y});
    return points;
}

Image TruePicture::image() const {
    Image image(part_.width, part_.height);
    for (std::size_t pixel = 0; pixel < pixels(); ++pixel) {
        const Color value = mean(pixel);
        for (int c = 0; c < 3; ++c) image.data[pixel * 3 + static_cast<std::size_t>(c)] = value[c];
    }
    return image;
}

double TruePicture::error() const {
    double squares = 0;
    for (std::size_t pixel = 0; pixel < pixels(); ++pixel) {
        const Color difference = half(0, pixel) - half(1, pixel);
        squares += dot(difference, difference);
    }
    return std::sqrt(squares / 4 / (3 * static_cast<double>(pixels())));
}

std::string TruePicture::bytes() const {
    std::string out;
    put(out, points_);
    for (const std::vector<Color>& sums : sums_)
        for (const Color& sum : sums)
            for (int c = 0; c < 3; ++c) put(out, std::bit_cast<std::uint64_t>(sum[c]));
    return out;
}

bool TruePicture::restore(std::string_view bytes) {
    if (bytes.size() != 8 + 2 * pixels() * 3 * 8) return false;
    const std::uint64_t points = number_at(bytes, 0);
    if (points == 0 || points > 1U << 20) return false;
    points_ = static_cast<std::uint32_t>(points);
    std::size_t at = 8;
    for (std::vector<Color>& sums : sums_)
        for (Color& sum : sums)
            for (int c = 0; c < 3; ++c, at += 8)
                sum[c] = std::bit_cast<double>(number_at(bytes, at));
    return true;
}

}  // namespace lancer::judge
