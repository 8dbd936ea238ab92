// Pictures in memory.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lancer {

/// Layout: `height` rows of `width` pixels of `channels` values, top row first. Values are linear
/// light, scene-referred, not clamped. Alpha, if present, is the fourth channel and not
/// premultiplied.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<double> data;
    /// Names of the channels after R, G, B (and A), for formats that can store them.
    std::vector<std::string> extra_names;

    Image() = default;
    Image(int w, int h, int c = 3)
        : width(w),
          height(h),
          channels(c),
          data(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
               static_cast<std::size_t>(c)) {}

    /// The number of channels without the extra ones: 1 is grey, 3 are R, G, B, and 4 include
    /// alpha.
    int color_channels() const { return channels - static_cast<int>(extra_names.size()); }

    std::size_t index(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
    double* pixel(int x, int y) { return data.data() + index(x, y); }
    const double* pixel(int x, int y) const { return data.data() + index(x, y); }
};

/// The picture as red, green, blue and, if present, alpha. Grey is copied to all three; extra
/// channels are dropped.
Image in_color(Image image);

}  // namespace lancer
