#include "judge/report/histogram.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "judge/report/html.h"
#include "model/elementary.h"

namespace lancer::judge {

namespace {

constexpr int lowest_decade = -7;
constexpr int per_decade = 5;
constexpr int bars = 1 - lowest_decade * per_decade;

constexpr double width = 440;
constexpr double height = 150;
constexpr double left = 34;
constexpr double top = 8;
constexpr double floor_y = height - 22;

double log10_of(double x) {
    return elementary::log(x) / elementary::log(10.0);
}

std::size_t bar_of(double difference) {
    if (!(difference > 0)) return 0;
    const double place = std::floor((log10_of(difference) - lowest_decade) * per_decade);
    return static_cast<std::size_t>(std::clamp(place, -1.0, bars - 2.0) + 1);
}

/// The first bar holds all smaller differences, so the scale begins one bar to the right.
double x_of(double log_difference) {
    const double bar = (width - left) / bars;
    return left + bar * (1 + (log_difference - lowest_decade) * per_decade);
}

}  // namespace

std::string histogram_svg(const std::vector<double>& differences,
                          const std::vector<double>& marks) {
    std::array<std::size_t, bars> counts{};
    for (const double d : differences) ++counts[bar_of(d)];
    const double most = std::max(1.0, std::ceil(log10_of(static_cast<double>(std::max<std::size_t>(
                                          1, *std::max_element(counts.begin(), counts.end()))))));
    // A single pixel must be visible, so the axis begins below it.
    const auto y_of = [&](double count) {
        return floor_y - (floor_y - top) * (log10_of(count) + 0.3) / (most + 0.3);
    };

    std::string svg = fmt::format(
        "<svg class=\"histogram\" viewBox=\"0 0 {:g} {:g}\" role=\"img\" "
        "aria-label=\"Histogram of the differences, both axes logarithmic\">",
        width, height);
    for (int decade = 0; decade <= static_cast<int>(most); ++decade) {
        const double y = y_of(elementary::pow(10.0, decade));
        svg += fmt::format(
            "<line class=\"axis\" x1=\"{:g}\" x2=\"{:g}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>"
            "<text x=\"{:g}\" y=\"{:.1f}\" text-anchor=\"end\">1e{}</text>",
            left, width, y, y, left - 4, y + 3, decade);
    }
    const double bar_width = (width - left) / bars;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] == 0) continue;
        const double y = y_of(static_cast<double>(counts[i]));
        const double low = lowest_decade + (static_cast<double>(i) - 1) / per_decade;
        const std::string range = i == 0
                                      ? std::string("equal or closer than 1e-7")
                                      : fmt::format("{:.1e} to {:.1e}", elementary::pow(10.0, low),
                                                    elementary::pow(10.0, low + 1.0 / per_decade));
        svg += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">"
            "<title>{}: {} pixels</title></rect>",
            left + bar_width * static_cast<double>(i) + 0.5, y, bar_width - 1, floor_y - y, range,
            counts[i]);
    }
    for (int decade = lowest_decade; decade <= 0; ++decade) {
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:g}\" text-anchor=\"{}\">1e{}</text>",
                           x_of(decade), floor_y + 14, decade == 0 ? "end" : "middle", decade);
    }
    int labelled = 0;  // labels stand below each other, since marks may be close together
    for (const double mark : marks) {
        if (!(mark > 1e-7)) continue;
        svg += fmt::format(
            "<line class=\"mark\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:g}\" y2=\"{2:g}\">"
            "<title>threshold {3:g}</title></line>",
            x_of(log10_of(mark)), top, floor_y, mark);
        svg += fmt::format("<text class=\"mark-label\" x=\"{:.1f}\" y=\"{:g}\">{}</text>",
                           x_of(log10_of(mark)) + 3, top + 7 + 11 * labelled++, shown(mark));
    }
    return svg + "</svg>";
}

}  // namespace lancer::judge
