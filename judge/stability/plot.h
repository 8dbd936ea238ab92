// Plots the share of wrong pixels against an exponent, as SVG.
#pragma once

#include <string>
#include <vector>

namespace lancer::judge {

struct PlotSeries {
    struct Point {
        int exponent = 0;
        double share = 0;  ///< of the pixels, 0..1
    };
    std::string name;           ///< of its line in the legend
    int color = 0;              ///< 0 to 5: a fixed palette, the same in all panels
    std::vector<Point> points;  ///< by exponent
};

struct PlotPanel {
    std::string title;
    std::string base;  ///< "10" or "2": the base of the exponent; empty: plain numbers
    std::vector<PlotSeries> series;
};

/// Panels side by side, `columns` in a row. The vertical scale is logarithmic, from one pixel of
/// `pixels` to all of them, with a line for "none" below. One legend at the top.
std::string plot_svg(const std::string& title, const std::vector<PlotPanel>& panels,
                     std::size_t pixels, int columns);

}  // namespace lancer::judge
