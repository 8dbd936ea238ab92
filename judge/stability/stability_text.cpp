#include "judge/stability/stability_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "judge/stability/plot.h"

namespace lancer::judge {
namespace {

bool is_range(Change change) {
    return base_of(change) != 0;
}

const Sample* sample_at(const std::vector<Sample>& samples, int exponent) {
    for (const Sample& s : samples)
        if (s.exponent == exponent) return &s;
    return nullptr;
}

const char* title_of(Change change) {
    switch (change) {
        case Change::scale:
            return "size, times 10^k";
        case Change::twos:
            return "size, times 2^k";
        case Change::shift:
            return "moved by 10^k";
        case Change::distance:
            return "camera, 10^k as far";
        case Change::axes:
            return "axes renamed";
        case Change::extended:
            return "against 64 bits";
    }
    return "";
}

std::string pixels_text(std::size_t count) {
    return fmt::format("{} pixel{}", count, count == 1 ? "" : "s");
}

/// Describes the first wrong sample beyond the window, or says that the window ends with the range
/// tried.
std::string beyond(const std::vector<Sample>& samples, Change change, int end, int sign,
                   std::size_t pixels) {
    const Sample* s = sample_at(samples, end + sign);
    if (s == nullptr || s->right) return "";
    const std::string at = power_text(change, s->exponent) + ": ";
    if (!s->failure.empty()) return at + s->failure.substr(0, s->failure.find('\n'));
    const std::size_t count = change == Change::twos ? s->different : s->wrong;
    return at + fmt::format("{} {}, {:.2g} %", pixels_text(count),
                            change == Change::twos ? "not the same" : "wrong",
                            100.0 * static_cast<double>(count) / static_cast<double>(pixels));
}

std::string row(const std::string& what, const std::string& from, const std::string& to,
                const std::string& then) {
    std::string line = fmt::format("  {:<20}{:>11}{:>9}  {}", what, from, to, then);
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
    std::string out;
    for (const std::string& part : parts)
        if (!part.empty()) out += (out.empty() ? "" : between) + part;
    return out;
}

std::string range_row(const Window& w, std::size_t pixels) {
    const Change change = w.trial.change;
    const int origin = w.trial.origin();
    const bool two_sided = change == Change::scale || change == Change::twos;
    if (w.samples.empty() && w.cut_short) return row(title_of(change), "", "", "no time for more");
    std::vector<std::string> notes;
    if (two_sided) notes.push_back(beyond(w.samples, change, w.lowest, -1, pixels));
    notes.push_back(beyond(w.samples, change, w.highest, 1, pixels));
    const Sample* first = sample_at(w.samples, origin);
    if (first != nullptr && !first->right)
        notes.insert(notes.begin(),
                     fmt::format("{} wrong without any change", pixels_text(first->wrong)));
    if (w.cut_short) notes.emplace_back("no time for more");
    const bool nothing = change == Change::shift && w.highest == origin;
    const auto end = [&](int at, int limit) {
        return power_text(change, at) + (at == limit ? "*" : " ");
    };
    return row(title_of(change), two_sided ? end(w.lowest, w.trial.low) : "",
               nothing ? "none " : end(w.highest, w.trial.high), joined(notes, "; "));
}

std::string fixed_row(const Window& w) {
    Sample worst;
    for (const Sample& s : w.samples) {
        worst.wrong = std::max(worst.wrong, s.wrong);
        worst.different = std::max(worst.different, s.different - s.wrong);
        worst.most = std::max(worst.most, s.most);
        if (worst.failure.empty()) worst.failure = s.failure;
    }
    std::vector<std::string> notes;
    if (!worst.failure.empty())
        notes.push_back(worst.failure);
    else if (!w.samples.empty())
        notes.push_back(fmt::format("{} wrong, {} more with other bits, by {:.2g} at most",
                                    pixels_text(worst.wrong), worst.different, worst.most));
    if (w.cut_short) notes.emplace_back("no time for more");
    return row(title_of(w.trial.change), "", "", joined(notes, "; "));
}

std::string povray_row(const PovRayWindow& p, std::size_t pixels) {
    if (!p.failure.empty())
        return row("POV-Ray", "", "", p.failure.substr(0, p.failure.find('\n')));
    const auto end = [&](int at, int limit) {
        return power_text(Change::scale, at) + (at == limit ? "*" : " ");
    };
    return row("POV-Ray, times 10^k", end(p.lowest, p.samples.front().exponent),
               end(p.highest, p.samples.back().exponent),
               joined({beyond(p.samples, Change::scale, p.lowest, -1, pixels),
                       beyond(p.samples, Change::scale, p.highest, 1, pixels)},
                      "; "));
}

}  // namespace

std::string power_text(Change change, int exponent) {
    if (exponent == 0) return "1";
    return base_of(change) == 2 ? fmt::format("2^{}", exponent) : fmt::format("1e{}", exponent);
}

std::string stability_head(const StabilityReport& report) {
    return fmt::format(
               "{}: {} x {} pixels, {}; a pixel is wrong when a channel is off by more than "
               "{:.4f}\n\n",
               report.scene, report.width, report.height, report.precision, report.options.fail) +
           row("change", "right from ", "to ", "then");
}

std::string stability_row(const StabilityReport& report, const Window& window) {
    return is_range(window.trial.change) ? range_row(window, report.pixels()) : fixed_row(window);
}

std::string stability_row(const StabilityReport& report, const PovRayWindow& povray) {
    return povray_row(povray, report.pixels());
}

std::string stability_foot(const StabilityReport& report) {
    std::string out = "  * the end of the range that was tried\n";
    for (const WindowDemand& d : report.demands)
        out += fmt::format("  demanded {}: {}\n", d.text, d.held ? "held" : "NOT HELD");
    return out;
}

namespace {

std::string clause(const Window& w) {
    const Change change = w.trial.change;
    const std::string high = power_text(change, w.highest);
    switch (change) {
        case Change::scale:
            if (w.lowest == 0 && w.highest == 0) return "right only at its own size";
            return fmt::format("right from {} to {} times its size", power_text(change, w.lowest),
                               high);
        case Change::twos:
            if (w.lowest == 0 && w.highest == 0) return "other bits already at twice its size";
            return fmt::format("the same bits from {} to {} times its size",
                               power_text(change, w.lowest), high);
        case Change::shift:
            if (w.highest == w.trial.origin())
                return fmt::format("wrong when moved by {}", power_text(change, w.trial.low));
            return fmt::format("moved by up to {}", high);
        case Change::distance:
            return fmt::format("right from up to {} times as far", high);
        case Change::axes:
            return w.holds() ? "with any names of the axes" : "not with other names of the axes";
        case Change::extended:
            return w.holds() ? "as with more digits" : "not as with more digits";
    }
    return "";
}

nlohmann::ordered_json json_of(const std::vector<Sample>& samples) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Sample& s : samples) {
        nlohmann::ordered_json entry{{"exponent", s.exponent},
                                     {"right", s.right},
                                     {"wrong", s.wrong},
                                     {"different", s.different},
                                     {"max", s.most}};
        if (!s.failure.empty()) entry["failure"] = s.failure;
        list.push_back(std::move(entry));
    }
    return list;
}

PlotSeries series_of(const std::string& name, int color, const std::vector<Sample>& samples,
                     std::size_t pixels, bool bits) {
    PlotSeries series{name, color, {}};
    for (const Sample& s : samples)
        series.points.push_back({s.exponent, static_cast<double>(bits ? s.different : s.wrong) /
                                                 static_cast<double>(pixels)});
    return series;
}

}  // namespace

std::string stability_sentence(const StabilityReport& report) {
    std::vector<std::string> clauses;
    for (const Window& w : report.windows)
        if (!w.samples.empty()) clauses.push_back(clause(w));
    std::string out = joined(clauses, ", ");
    if (report.povray && report.povray->failure.empty()) {
        out += fmt::format("{}POV-Ray from {} to {} times its size", out.empty() ? "" : "; ",
                           power_text(Change::scale, report.povray->lowest),
                           power_text(Change::scale, report.povray->highest));
    }
    return out;
}

namespace {

nlohmann::ordered_json json_of(const StabilityReport& report) {
    nlohmann::ordered_json json;
    json["scene"] = report.scene;
    json["precision"] = report.precision;
    json["width"] = report.width;
    json["height"] = report.height;
    json["fail"] = report.options.fail;
    json["fail_percent"] = report.options.fail_percent;
    json["sentence"] = stability_sentence(report);
    json["changes"] = nlohmann::ordered_json::array();
    for (const Window& w : report.windows) {
        nlohmann::ordered_json entry{{"change", name_of(w.trial.change)}};
        if (is_range(w.trial.change)) {
            entry["base"] = base_of(w.trial.change);
            entry["tried"] = {w.trial.low, w.trial.high};
            entry["right"] = {w.lowest, w.highest};
        } else {
            entry["right"] = w.holds();
        }
        entry["cut_short"] = w.cut_short;
        entry["samples"] = json_of(w.samples);
        json["changes"].push_back(std::move(entry));
    }
    json["povray"] = nullptr;
    if (report.povray) {
        const PovRayWindow& p = *report.povray;
        json["povray"] = {{"version", p.version}};
        if (!p.failure.empty()) {
            json["povray"]["failure"] = p.failure;
        } else {
            json["povray"]["best"] = p.best;
            json["povray"]["right"] = {p.lowest, p.highest};
            json["povray"]["samples"] = json_of(p.samples);
        }
    }
    json["demands"] = nlohmann::ordered_json::array();
    for (const WindowDemand& d : report.demands)
        json["demands"].push_back({{"demand", d.text}, {"held", d.held}});
    return json;
}

}  // namespace

std::string stability_json(const std::vector<StabilityReport>& reports) {
    nlohmann::ordered_json json;
    if (reports.size() == 1) {
        json = json_of(reports.front());
    } else {
        json["scenes"] = nlohmann::ordered_json::array();
        for (const StabilityReport& report : reports) json["scenes"].push_back(json_of(report));
    }
    return json.dump(2) + "\n";
}

std::string stability_plot(const StabilityReport& report) {
    const std::size_t pixels = report.pixels();
    std::vector<PlotPanel> panels;
    bool povray = report.povray && !report.povray->samples.empty();
    for (const Window& w : report.windows) {
        if (!is_range(w.trial.change) || w.samples.empty()) continue;
        const bool bits = w.trial.change == Change::twos;
        PlotPanel panel{title_of(w.trial.change), std::to_string(base_of(w.trial.change)), {}};
        if (bits) panel.title += ": pixels with other bits";
        panel.series.push_back(
            series_of("Lancer, " + report.precision, 0, w.samples, pixels, bits));
        if (w.trial.change == Change::scale && povray) {
            panel.series.push_back(series_of("POV-Ray", 1, report.povray->samples, pixels, false));
            povray = false;
        }
        panels.push_back(std::move(panel));
    }
    if (povray)
        panels.push_back({"size, times 10^k",
                          "10",
                          {series_of("POV-Ray", 1, report.povray->samples, pixels, false)}});
    return plot_svg("Wrong pixels: " + report.scene, panels, pixels, 2);
}

}  // namespace lancer::judge
