#include "judge/explain/outlier.h"

#include <array>
#include <utility>

#include "reference/compare/compare.h"

namespace lancer::judge {

namespace {

/// The means of opposite points around a pixel's centre, for four pairs.
using Around = std::array<Color, 4>;
template <class At>
Around means(const At& at) {
    Around out;
    std::size_t i = 0;
    for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}})
        out[i++] = 0.5 * (at(x, y) + at(-x, -y));
    return out;
}

/// Whether two pictures agree around a pixel. Two pairs are needed: a single pair may lie along a
/// streak.
bool agree_around(const Around& a, const Around& b, double tolerance) {
    int pairs = 0;
    for (std::size_t i = 0; i < a.size(); ++i) pairs += distance(a[i], b[i]) <= tolerance;
    return pairs >= 2;
}

/// Whether an edge runs exactly through the centre, where the other program has a third value,
/// while both programs agree at all points around it and our value is that of one side.
bool is_on_edge(const DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
                const Image& around, double pitch) {
    bool of_one_side = false;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            if (i == 0 && j == 0) continue;
            const Color ours = probe(pixel.x + 0.5 + i * pitch, pixel.y + 0.5 + j * pitch).color;
            const Color theirs = color_at(around, 1 + i, 1 + j);
            if (distance(ours, theirs) > limits.interior) return false;
            of_one_side = of_one_side || distance(ours, pixel.ours) <= limits.interior;
        }
    }
    return of_one_side;
}

/// Whether the other program's picture contradicts its own pixel: `pitch` pixels around it, it has
/// our value or what its rules make of our value.
bool is_denied(const DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
               const SecondLook& second, double pitch) {
    const Image image = second.around(pixel.x, pixel.y, pitch);
    if (is_on_edge(pixel, probe, limits, image, pitch)) return true;
    const Around theirs = means([&](int x, int y) { return color_at(image, 1 + x, 1 + y); });
    Around ours;
    ours.fill(pixel.ours);
    if (agree_around(theirs, ours, limits.interior)) return true;
    if (!second.by_rules || !second.without) return false;
    const double x = pixel.x + 0.5;
    const double y = pixel.y + 0.5;
    const Around by_rules =
        means([&](int i, int j) { return second.by_rules(x + i * pitch, y + j * pitch).color; });
    return agree_around(theirs, by_rules, limits.interior) &&
           distance(second.without(x, y).color, pixel.ours) <= limits.tight;
}

}  // namespace

/// Two distances are tried: a faulty solver leaves streaks that may be wider than the radius for
/// edges.
bool is_outlier(const DifferentPixel& pixel, const ProbeFunction& probe, const Thresholds& limits,
                const SecondLook& second) {
    return is_denied(pixel, probe, limits, second, limits.radius) ||
           is_denied(pixel, probe, limits, second, 10 * limits.radius);
}

}  // namespace lancer::judge
