#include "accuracy/picture_samples.h"

#include <algorithm>

#include "model/sobol.h"

namespace lancer::accuracy {

void PixelSums::add(const Color& sample) {
    sum += sample;
    squares += dot(sample, sample);
    ++count;
}

double PixelSums::variance() const {
    if (count < 2) return 0;
    const double n = count;
    return std::max(0.0, (squares - dot(sum, sum) / n) / (n - 1));
}

PictureSamples::PictureSamples(const Renderer& renderer, const View& view,
                               const TraceLimits& limits, std::uint64_t seed,
                               const PictureRows& rows)
    : renderer_(renderer),
      view_(view),
      limits_(limits),
      seed_(seed),
      crop_(view.crop.value_or(Crop{0, 0, view.width, view.height})),
      part_(rows.part) {
    const auto add = [&](const RowRange& range) {
        for (int y = 0; y < range.count; ++y) rows_.push_back(crop_.y + range.first + y);
    };
    for (const RowRange& range : rows.ranges) add(range);
    if (rows.ranges.empty()) add({0, crop_.height});
    pixels_.resize(static_cast<std::size_t>(crop_.width) * rows_.size());
}

int PictureSamples::column(std::size_t pixel) const {
    return crop_.x + static_cast<int>(pixel % static_cast<std::size_t>(crop_.width));
}

int PictureSamples::row(std::size_t pixel) const {
    return rows_[pixel / static_cast<std::size_t>(crop_.width)];
}

std::size_t PictureSamples::pixel_at(int column, int row) const {
    const auto y = std::lower_bound(rows_.begin(), rows_.end(), row) - rows_.begin();
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(crop_.width) +
           static_cast<std::size_t>(column - crop_.x);
}

std::uint64_t PictureSamples::key(std::uint64_t stream) const {
    return pixel_key(seed_, -1, -1 - part_, stream);
}

void PictureSamples::trace(const std::vector<Run>& runs, const std::vector<PicturePoint>& points) {
    std::vector<Color> colors(points.size());
    renderer_.trace(view_, points, limits_, colors, {}, rays_);
    std::size_t next = 0;
    for (const Run& run : runs)
        for (std::uint32_t i = 0; i < run.points; ++i) pixels_[run.pixel].add(colors[next++]);
}

void PictureSamples::raise(std::span<const std::uint32_t> wanted, const Progress& progress) {
    std::vector<Run> runs;
    std::vector<PicturePoint> points;
    for (std::size_t pixel = 0; pixel < size(); ++pixel) {
        PixelSums& sums = pixels_[pixel];
        if (wanted[pixel] > sums.count) {
            const int x = column(pixel);
            const int y = row(pixel);
            const SobolPoints sequence(pixel_key(seed_, x, y));
            for (std::uint32_t i = sums.count; i < wanted[pixel]; ++i)
                points.push_back({x + sequence[i].x, y + sequence[i].y});
            runs.push_back({pixel, wanted[pixel] - sums.count});
        }
        if (points.empty() || (points.size() < batch_size && pixel + 1 < size())) continue;
        trace(runs, points);
        runs.clear();
        points.clear();
        if (progress) progress(static_cast<double>(pixel + 1) / static_cast<double>(size()));
    }
}

Image PictureSamples::image() const {
    Image image(width(), height());
    for (std::size_t pixel = 0; pixel < size(); ++pixel) {
        const Color mean = pixels_[pixel].mean();
        for (int c = 0; c < 3; ++c) image.data[pixel * 3 + static_cast<std::size_t>(c)] = mean[c];
    }
    return image;
}

}  // namespace lancer::accuracy
