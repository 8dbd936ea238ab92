#include "judge/stability/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "judge/report/html.h"

namespace lancer::judge {
namespace {

// The palette of Okabe and Ito, which colour-blind readers can distinguish.
constexpr const char* colors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr int color_count = 6;

constexpr double panel_width = 340;
constexpr double panel_height = 190;
constexpr double left = 52;
constexpr double right = 14;
constexpr double top = 30;
constexpr double bottom = 34;
constexpr double head = 58;
constexpr double none_row = 22;  ///< height of the line for "none"

/// The label step that gives at most eight labels.
int label_step(int span) {
    for (const int step : {1, 2, 5, 10, 20, 25, 50, 100, 200})
        if (span / step <= 8) return step;
    return std::max(1, span / 8);
}

class PanelDrawing {
  public:
    PanelDrawing(const PlotPanel& panel, std::size_t pixels, double x, double y)
        : panel_(panel), least_(1.0 / static_cast<double>(pixels)), x_(x), y_(y) {
        bool first = true;
        for (const PlotSeries& series : panel.series) {
            for (const PlotSeries::Point& p : series.points) {
                low_ = first ? p.exponent : std::min(low_, p.exponent);
                high_ = first ? p.exponent : std::max(high_, p.exponent);
                first = false;
            }
        }
        if (low_ == high_) --low_, ++high_;
    }

    std::string draw() const {
        std::string out = fmt::format("<text class=\"t\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                                      x_ + left, y_ + 18, escaped(panel_.title));
        out += axes();
        for (std::size_t i = 0; i < panel_.series.size(); ++i) out += line(panel_.series[i], i);
        return out;
    }

  private:
    double bottom_edge() const { return y_ + panel_height - bottom; }
    double at(int exponent) const {
        const double inside = panel_width - left - right - 12;
        return x_ + left + 6 + inside * (exponent - low_) / (high_ - low_);
    }
    double height_of(double share) const {
        if (!(share > 0)) return bottom_edge() - none_row / 2;
        const double room = panel_height - top - bottom - none_row - 6;
        const double part = 1 - std::log10(std::max(share, least_)) / std::log10(least_);
        return bottom_edge() - none_row - room * part;
    }

    std::string power(int k) const {
        if (panel_.base.empty()) return std::to_string(k);
        return fmt::format("{}<tspan class=\"u\" dy=\"-4\">{}</tspan>", panel_.base, k);
    }

    std::string axes() const {
        const double x0 = x_ + left;
        const double x1 = x_ + panel_width - right;
        std::string out = fmt::format(
            "<rect class=\"f\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
            x0, y_ + top, x1 - x0, panel_height - top - bottom);
        const auto level = [&](double share, const std::string& label) {
            const double y = height_of(share);
            out += fmt::format(
                "<line class=\"g\" x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\"/>"
                "<text class=\"e\" x=\"{3:.1f}\" y=\"{4:.1f}\">{5}</text>\n",
                x0, y, x1, x0 - 5, y + 3.5, label);
        };
        level(0, "none");
        level(least_, "1 px");
        for (const auto& [share, label] :
             {std::pair{1e-3, "0.1 %"}, {1e-2, "1 %"}, {1e-1, "10 %"}, {1.0, "all"}})
            if (share > 3 * least_ || share == 1) level(share, label);
        const int step = label_step(high_ - low_);
        const int begin = static_cast<int>(std::ceil(static_cast<double>(low_) / step)) * step;
        for (int k = begin; k <= high_; k += step) {
            out += fmt::format(
                "<line class=\"g\" x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\"/>"
                "<text class=\"m\" x=\"{0:.1f}\" y=\"{3:.1f}\">{4}</text>\n",
                at(k), bottom_edge(), bottom_edge() + 4, bottom_edge() + 17, power(k));
        }
        return out;
    }

    std::string line(const PlotSeries& series, std::size_t index) const {
        const char* color = colors[series.color % color_count];
        // Moves curves apart that would cover each other.
        const double aside =
            (static_cast<double>(index) - static_cast<double>(panel_.series.size() - 1) / 2) * 2;
        std::string points;
        std::string marks;
        for (const PlotSeries::Point& p : series.points) {
            const double px = at(p.exponent);
            const double py = height_of(p.share) + aside;
            points += fmt::format("{:.1f},{:.1f} ", px, py);
            marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\" fill=\"{}\"/>", px,
                                 py, color);
        }
        return fmt::format(
                   "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>",
                   points, color) +
               marks + "\n";
    }

    const PlotPanel& panel_;
    double least_;
    double x_;
    double y_;
    int low_ = 0;
    int high_ = 0;
};

std::string legend(const std::vector<PlotPanel>& panels) {
    std::map<int, std::string> names;
    for (const PlotPanel& panel : panels)
        for (const PlotSeries& series : panel.series) names.try_emplace(series.color, series.name);
    std::string out;
    double x = left;
    for (const auto& [color, name] : names) {
        out += fmt::format(
            "<line x1=\"{0:.1f}\" y1=\"42\" x2=\"{1:.1f}\" y2=\"42\" stroke=\"{2}\" "
            "stroke-width=\"3\"/><text x=\"{3:.1f}\" y=\"46\">{4}</text>\n",
            x, x + 18, colors[color % color_count], x + 23, escaped(name));
        x += 44 + 6.5 * static_cast<double>(name.size());
    }
    return out;
}

}  // namespace

std::string plot_svg(const std::string& title, const std::vector<PlotPanel>& panels,
                     std::size_t pixels, int columns) {
    const int count = static_cast<int>(panels.size());
    const int across = std::clamp(count, 1, std::max(columns, 1));
    const int down = (count + across - 1) / across;
    const double width = std::max(across, 2) * panel_width;
    const double height = head + down * panel_height + 6;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"11\">\n"
        "<style>.t{{font-size:11px;font-weight:bold}}.f{{fill:none;stroke:#999}}"
        ".g{{stroke:#ddd}}.e{{text-anchor:end;fill:#444}}.m{{text-anchor:middle;fill:#444}}"
        ".u{{font-size:8px}}</style>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        "<text x=\"{2:.0f}\" y=\"24\" font-size=\"15\" font-weight=\"bold\">{3}</text>\n",
        width, height, left, escaped(title));
    out += legend(panels);
    for (int i = 0; i < count; ++i) {
        const PlotPanel& panel = panels[static_cast<std::size_t>(i)];
        out += PanelDrawing(panel, std::max<std::size_t>(pixels, 2), (i % across) * panel_width,
                            head + (i / across) * panel_height)
                   .draw();
    }
    return out + "</svg>\n";
}

}  // namespace lancer::judge
