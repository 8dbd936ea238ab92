#include "judge/tradeoff/scatter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "judge/report/html.h"
#include "judge/tradeoff/page.h"
#include "judge/tradeoff/tradeoff_text.h"

namespace lancer::judge {
namespace {

constexpr double width = 560;
constexpr double height = 430;
constexpr double left = 74;
constexpr double right = 16;
constexpr double top = 14;
constexpr double bottom = 52;
constexpr double legend_row = 20;

/// Outlines within a circle of radius 5 that differ even without colours.
const char* outline_of(Knob knob) {
    switch (knob) {
        case Knob::max_error:
            return "M0,-5.5L5,4H-5Z";
        case Knob::combination:
            return "M0,-5.5L5.5,0L0,5.5L-5.5,0Z";
        case Knob::scene:
        case Knob::exact:
        case Knob::quality:
            return "M-1.7,-5h3.4v3.3h3.3v3.4h-3.3v3.3h-3.4v-3.3h-3.3v-3.4h3.3Z";
        case Knob::tolerance:
        case Knob::precision:
            return "M-4,-4H4V4H-4Z";
        case Knob::shadows:
        case Knob::smooth:
        case Knob::textures:
            return "M0,5.5L5,-4H-5Z";
        default:
            return "M-4.5,0a4.5,4.5 0 1,0 9,0a4.5,4.5 0 1,0 -9,0Z";
    }
}

/// One axis: a range of powers of ten, with room at both ends.
struct Axis {
    double low = 0;
    double high = 1;
    double from = 0;
    double to = 1;

    double at(double value) const {
        return from + (to - from) * (std::log10(value) - low) / (high - low);
    }
    /// The values 1, 2 and 5 times powers of ten within the range.
    std::vector<double> ticks() const {
        std::vector<double> found;
        for (int k = static_cast<int>(std::floor(low)) - 1; k <= high; ++k) {
            for (const double digit : {1.0, 2.0, 5.0}) {
                const double value = digit * std::pow(10.0, k);
                const double at = std::log10(value);
                if (at >= low && at <= high) found.push_back(value);
            }
        }
        if (found.size() > 9)  // powers of ten alone
            std::erase_if(found, [](double v) {
                const double power = std::log10(v);
                return std::abs(power - std::round(power)) > 1e-9;
            });
        return found;
    }
};

class Drawing {
  public:
    Drawing(const TradeOffReport& report, const std::string& prefix)
        : report_(report), prefix_(prefix) {
        std::vector<double> seconds;
        std::vector<double> errors;
        for (const Measurement& m : report.settings) {
            seconds.push_back(std::max(1e-6, m.counted()));
            if (m.error.counted() > 0) errors.push_back(m.error.counted());
        }
        if (errors.empty()) errors = {1e-3, 1};
        x_ = range(seconds, left, width - right);
        y_ = range(errors, height - bottom, top);
    }

    std::string draw() const { return grid() + frontier_line() + points(); }

  private:
    static Axis range(const std::vector<double>& values, double from, double to) {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        return {std::log10(*least) - 0.12, std::log10(*most) + 0.12, from, to};
    }
    /// An error of zero is drawn on the axis.
    double height_of(const Measurement& m) const {
        const double error = m.error.counted();
        return error > 0 ? y_.at(error) : height - bottom;
    }
    double place_of(const Measurement& m) const { return x_.at(std::max(1e-6, m.counted())); }

    std::string grid() const {
        std::string out =
            fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                        left, top, width - left - right, height - top - bottom);
        for (const double v : x_.ticks())
            out += fmt::format(
                "<path class=\"grid\" d=\"M{0:.1f},{1}V{2}\"/><text class=\"tick middle\" "
                "x=\"{0:.1f}\" y=\"{3}\">{4}</text>\n",
                x_.at(v), top, height - bottom, height - bottom + 18, shown(v, 2));
        for (const double v : y_.ticks())
            out += fmt::format(
                "<path class=\"grid\" d=\"M{0},{1:.1f}H{2}\"/><text class=\"tick end\" x=\"{3}\" "
                "y=\"{4:.1f}\">{5}</text>\n",
                left, y_.at(v), width - right, left - 6, y_.at(v) + 4.5, shown(v, 2));
        for (const Advice& a : report_.advice) {
            const double y = y_.at(a.below);
            if (y < top || y > height - bottom) continue;
            out += fmt::format(
                "<path class=\"mark\" d=\"M{0},{1:.1f}H{2}\"/><text class=\"mark-name end\" "
                "x=\"{3}\" y=\"{4:.1f}\">{5}</text>\n",
                left, y, width - right, width - right - 4, y - 4, a.below_text);
        }
        out += fmt::format(
            "<text class=\"axis middle\" x=\"{}\" y=\"{}\">cost, seconds of the processor</text>"
            "<text class=\"axis middle\" transform=\"translate(14,{}) rotate(-90)\">error (RMSE, "
            "linear light)</text>\n",
            (left + width - right) / 2, height - 10, (top + height - bottom) / 2);
        return out;
    }

    std::string frontier_line() const {
        std::string path;
        for (const std::size_t i : by_cost(report_)) {
            const Measurement& m = report_.settings[i];
            if (m.beaten_by) continue;
            path +=
                fmt::format("{}{:.1f},{:.1f}", path.empty() ? "M" : "L", place_of(m), height_of(m));
        }
        return "<path class=\"best\" d=\"" + path + "\"/>\n";
    }

    /// From fast to slow; points of the frontier are drawn above the others. Links follow in this
    /// order.
    std::string points() const {
        std::string beaten;
        std::string best;
        for (const std::size_t i : by_cost(report_))
            (report_.settings[i].beaten_by ? beaten : best) += point(i);
        return beaten + best;
    }

    std::string point(std::size_t i) const {
        const Measurement& m = report_.settings[i];
        const std::string text = fmt::format("{}: cost {} s, error {}", m.setting.label,
                                             shown(m.counted()), error_text(m.error));
        const std::string style = group_of(m.setting.knob).style + (m.beaten_by ? " beaten" : "");
        std::string whisker;
        if (m.error.high > 0 && m.error.low > 0)
            whisker =
                fmt::format("<path class=\"whisker\" d=\"M0,{:.1f}V{:.1f}\"/>",
                            y_.at(m.error.low) - height_of(m), y_.at(m.error.high) - height_of(m));
        const std::string body =
            fmt::format("{}<path class=\"dot\" d=\"{}\"/>", whisker, outline_of(m.setting.knob));
        const std::string place =
            fmt::format("translate({:.1f},{:.1f})", place_of(m), height_of(m));
        if (prefix_.empty())
            return fmt::format("<g class=\"point {}\" transform=\"{}\"><title>{}</title>{}</g>\n",
                               style, place, escaped(text), body);
        return fmt::format(
            "<a class=\"point {}\" href=\"#{}{}\" data-setting=\"{}\" aria-label=\"{}\" "
            "transform=\"{}\"><circle class=\"reach\" r=\"9\"/>{}</a>\n",
            style, prefix_, i, i, escaped(text), place, body);
    }

    const TradeOffReport& report_;
    const std::string& prefix_;
    Axis x_;
    Axis y_;
};

// The palette of Okabe and Ito, which colour-blind readers can distinguish.
constexpr const char* document_style =
    "text{font-size:13px;fill:#333}.middle{text-anchor:middle}.end{text-anchor:end}"
    ".frame{fill:none;stroke:#888}.grid{stroke:#e2e2e2;fill:none}.mark{stroke:#c02626;fill:none;"
    "stroke-dasharray:4 3}.mark-name{fill:#c02626;font-size:11px}.best{fill:none;stroke:#444;"
    "stroke-width:1.5}.whisker{stroke:#444}.dot{fill:currentColor;stroke:#fff;stroke-width:1}"
    ".beaten .dot{fill:#fff;stroke:currentColor}.k-samples{color:#0072b2}.k-depth{color:#d55e00}"
    ".k-numbers{color:#009e73}.k-switches{color:#cc79a7}.k-error{color:#b8860b}"
    ".k-several{color:#3d3dc4}.k-marks{color:#111}";

}  // namespace

KnobGroup group_of(Knob knob) {
    switch (knob) {
        case Knob::scene:
        case Knob::exact:
        case Knob::quality:
            return {"the scene's own, --quality, exact", "k-marks"};
        case Knob::samples:
            return {"samples", "k-samples"};
        case Knob::max_depth:
        case Knob::min_contribution:
            return {"depth, contribution", "k-depth"};
        case Knob::tolerance:
        case Knob::precision:
            return {"tolerance, precision", "k-numbers"};
        case Knob::shadows:
        case Knob::smooth:
        case Knob::textures:
            return {"shadows, normals, textures off", "k-switches"};
        case Knob::max_error:
            return {"an error asked for", "k-error"};
        case Knob::combination:
            return {"combinations", "k-several"};
    }
    return {};
}

std::string scatter_key(Knob knob) {
    return fmt::format(
        "<svg class=\"key {}\" viewBox=\"-6 -6 12 12\" width=\"12\" height=\"12\" "
        "aria-hidden=\"true\"><path class=\"dot\" d=\"{}\"/></svg>",
        group_of(knob).style, outline_of(knob));
}

std::string scatter_for_page(const TradeOffReport& report, const std::string& prefix) {
    return fmt::format(
               "<svg class=\"scatter\" viewBox=\"0 0 {} {}\" role=\"group\" aria-label=\"Time "
               "against error, a point for each setting\">\n",
               width, height) +
           Drawing(report, prefix).draw() + "</svg>\n";
}

std::string scatter_document(const TradeOffReport& report) {
    std::map<std::string, Knob> groups;
    for (const Measurement& m : report.settings)
        groups.try_emplace(group_of(m.setting.knob).name, m.setting.knob);
    std::string legend;
    double y = height + 8;
    for (const auto& [name, knob] : groups) {
        legend += fmt::format(
            "<g class=\"{}\" transform=\"translate({},{})\"><path class=\"dot\" d=\"{}\"/><text "
            "x=\"12\" y=\"4.5\">{}</text></g>\n",
            group_of(knob).style, left, y, outline_of(knob), escaped(name));
        y += legend_row;
    }
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
               "height=\"{1}\" font-family=\"sans-serif\">\n<!-- {2} -->\n<title>{3}</title>\n"
               "<style>{4}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
               width, y, tradeoff_mark, escaped(report.scene), document_style) +
           Drawing(report, "").draw() + legend + "</svg>\n";
}

}  // namespace lancer::judge
