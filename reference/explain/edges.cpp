#include "reference/explain/edges.h"

#include <algorithm>

namespace lancer::reference {

namespace {

/// How far from a pixel's centre its slope is measured, in pixels.
constexpr double step = 0.01;
/// A step this many times larger than the slopes on its two sides predict is none of theirs.
constexpr double sharpness = 4;

bool is_edge(const Image& image, const Probe& probe, int x, int y, int dx, int dy) {
    const double ax = x + 0.5;
    const double ay = y + 0.5;
    const double bx = ax + dx;
    const double by = ay + dy;
    const ProbeSample a = probe(ax, ay);
    const ProbeSample b = probe(bx, by);
    if (a.object != b.object || a.lit != b.lit) return true;
    const double slope_a = distance(probe(ax + dx * step, ay + dy * step).color, a.color) / step;
    const double slope_b = distance(probe(bx - dx * step, by - dy * step).color, b.color) / step;
    const double contrast = distance(color_at(image, x, y), color_at(image, x + dx, y + dy));
    return contrast > sharpness * std::max(slope_a, slope_b);
}

}  // namespace

Mask find_edges(const Image& image, const Probe& probe, double contrast) {
    Mask edges(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    const auto flag = [&](int x, int y) -> std::uint8_t& {
        return edges[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x)];
    };
    const auto look = [&](int x, int y, int dx, int dy) {
        const double here = distance(color_at(image, x, y), color_at(image, x + dx, y + dy));
        if (here >= contrast && is_edge(image, probe, x, y, dx, dy)) {
            flag(x, y) = 1;
            flag(x + dx, y + dy) = 1;
        }
    };
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (x + 1 < image.width) look(x, y, 1, 0);
            if (y + 1 < image.height) look(x, y, 0, 1);
        }
    }
    return edges;
}

}  // namespace lancer::reference
