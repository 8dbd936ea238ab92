#include "reference/compare/picture_edges.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace lancer::reference {

namespace {

std::size_t index_of(const Image& image, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
           static_cast<std::size_t>(x);
}

/// A row or a column of pixels.
class Line {
  public:
    Line(const Image& image, int channels, int fixed, bool across)
        : image_(image), channels_(channels), fixed_(fixed), across_(across) {}

    int length() const { return across_ ? image_.width : image_.height; }
    std::size_t pixel(int i) const {
        return across_ ? index_of(image_, i, fixed_) : index_of(image_, fixed_, i);
    }
    /// The largest difference of a channel; 0 when one of the pixels is outside.
    double change(int i, int j) const {
        if (i < 0 || j < 0 || i >= length() || j >= length()) return 0;
        double largest = 0;
        for (int c = 0; c < channels_; ++c)
            largest = std::max(largest, std::abs(value(i, c) - value(j, c)));
        return largest;
    }
    /// Whether the picture has a step from pixel i to pixel j, one or two pixels further.
    bool steps(int i, int j) const {
        const double height = change(i, j);
        return height >= least_step && height >= step_against_slopes * change(i - 1, i) &&
               height >= step_against_slopes * change(j, j + 1);
    }

  private:
    double value(int i, int c) const {
        return (across_ ? image_.pixel(i, fixed_) : image_.pixel(fixed_, i))[c];
    }

    const Image& image_;
    int channels_;
    int fixed_;
    bool across_;
};

void mark_edges(const Line& line, std::vector<std::uint8_t>& flags) {
    for (int i = 0; i + 1 < line.length(); ++i) {
        for (const int width : {1, 2}) {
            if (i + width >= line.length() || !line.steps(i, i + width)) continue;
            for (int j = i; j <= i + width; ++j) flags[line.pixel(j)] = 1;
        }
    }
}

/// Whether each channel of `of` at (x, y) lies within the range of `among` around that pixel.
bool lies_within(const Image& of, const Image& among, int x, int y, int channels,
                 double tolerance) {
    for (int c = 0; c < channels; ++c) {
        double least = among.pixel(x, y)[c];
        double most = least;
        for (int j = std::max(0, y - 1); j <= std::min(among.height - 1, y + 1); ++j) {
            for (int i = std::max(0, x - 1); i <= std::min(among.width - 1, x + 1); ++i) {
                least = std::min(least, among.pixel(i, j)[c]);
                most = std::max(most, among.pixel(i, j)[c]);
            }
        }
        const double value = of.pixel(x, y)[c];
        if (!(value >= least - tolerance && value <= most + tolerance)) return false;
    }
    return true;
}

}  // namespace

std::vector<std::uint8_t> find_picture_edges(const Image& image, int channels) {
    std::vector<std::uint8_t> flags(
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 0);
    for (int y = 0; y < image.height; ++y) mark_edges({image, channels, y, true}, flags);
    for (int x = 0; x < image.width; ++x) mark_edges({image, channels, x, false}, flags);
    return flags;
}

std::vector<std::uint8_t> find_moved_edges(const Image& a, const Image& b, int channels,
                                           double tolerance) {
    assert(a.width == b.width && a.height == b.height);
    std::vector<std::uint8_t> flags = find_picture_edges(a, channels);
    const std::vector<std::uint8_t> others = find_picture_edges(b, channels);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t i = index_of(a, x, y);
            const bool has_edge = flags[i] != 0 || others[i] != 0;
            flags[i] = has_edge && lies_within(a, b, x, y, channels, tolerance) &&
                       lies_within(b, a, x, y, channels, tolerance);
        }
    }
    return flags;
}

}  // namespace lancer::reference
