#include "judge/tradeoff/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "judge/report/html.h"
#include "judge/report/page_assets.h"
#include "judge/report/report.h"
#include "judge/tradeoff/page_assets.h"
#include "judge/tradeoff/scatter.h"
#include "judge/tradeoff/tradeoff_text.h"
#include "model/diagnostic.h"
#include "model/io/file.h"

namespace lancer::judge {
namespace {

std::string picture(const std::string& png, const TradeOffReport& r, const std::string& caption) {
    if (png.empty()) return {};
    return fmt::format(
        "<figure><div class=\"frame\"><img alt=\"{0}\" width=\"{1}\" height=\"{2}\" "
        "src=\"data:image/png;base64,{3}\"></div><figcaption>{0}</figcaption></figure>",
        escaped(caption), r.width(), r.height(), base64(png));
}

std::string command(const Measurement& m) {
    return m.setting.options.empty() ? "(no options)" : m.setting.options;
}

/// A setting's card, shown when the pointer is on its point or row.
std::string detail(const TradeOffReport& r, std::size_t i, const std::string& prefix) {
    const Measurement& m = r.settings[i];
    std::string html = fmt::format(
        "<div class=\"detail{}\" id=\"{}{}\"><h3>{}. {} <span class=\"badge {}\">{}</span></h3>"
        "<pre>{}</pre><div class=\"pictures\">",
        i == r.exact ? " first" : "", prefix, i, i + 1, escaped(m.setting.label),
        m.beaten_by ? "refused" : "agrees",
        m.beaten_by ? fmt::format("beaten by {}", *m.beaten_by + 1) : "on the frontier",
        escaped(command(m)));
    html += picture(m.png, r, "Picture");
    html += picture(m.error_png, r, "Difference from the truth, logarithmic from 1e-6 to 1");
    html += picture(m.guessed_png, r, "The same, as predicted by the setting");
    html += picture(m.samples_png, r, "Samples per pixel: doubled from black to white");
    html += fmt::format(
        "</div><p>RMSE {} · 99.9 % {} · FLIP {}<br>{} s of the processor, cost {} s, {} times as "
        "fast as "
        "exact · {} rays per pixel · shadow {} · reflected {} · transmitted {}{}</p></div>\n",
        error_text(m.error), shown(m.error.p999, 2), shown(m.error.flip, 2), shown(m.median()),
        shown(m.counted()), shown(r.settings[r.exact].counted() / std::max(1e-9, m.counted()), 2),
        shown(static_cast<double>(m.rays.primary) / r.pixels()), m.rays.shadow, m.rays.reflected,
        m.rays.transmitted,
        m.memory_bytes ? fmt::format(" · {:.1f} MB", static_cast<double>(*m.memory_bytes) / 1e6)
                       : "");
    return html;
}

std::string table(const TradeOffReport& r, const std::string& prefix) {
    std::string html =
        "<div class=\"table\"><table class=\"settings\"><thead><tr><th class=\"number\">No</th>"
        "<th>Setting</th><th class=\"number\">Cost, s</th><th class=\"number\">Time, s</th><th "
        "class=\"number\">Rays per pixel</th>"
        "<th class=\"number\">MB</th><th class=\"number\">RMSE</th><th class=\"number\">95 %</th>"
        "<th class=\"number\">99.9 %</th><th class=\"number\">FLIP</th><th></th></tr></thead>"
        "<tbody>\n";
    for (const std::size_t i : by_cost(r)) {
        const Measurement& m = r.settings[i];
        html += fmt::format(
            "<tr class=\"{}\" data-setting=\"{}\"><td class=\"number\">{}</td><td>{} <a "
            "href=\"#{}{}\">{}</a></td>",
            m.beaten_by ? "beaten" : "best", i, i + 1, scatter_key(m.setting.knob), prefix, i,
            escaped(m.setting.label));
        for (const std::string& cell :
             {shown(m.counted()), shown(m.median()),
              shown(static_cast<double>(m.rays.primary) / r.pixels()),
              m.memory_bytes ? fmt::format("{:.1f}", static_cast<double>(*m.memory_bytes) / 1e6)
                             : "",
              m.error.is_told() ? shown(m.error.rmse) : "below " + shown(m.error.high, 2),
              m.error.is_told() ? shown(m.error.low) + " to " + shown(m.error.high) : "",
              shown(m.error.p999, 2), shown(m.error.flip, 2)})
            html += "<td class=\"number\">" + cell + "</td>";
        html += fmt::format("<td>{}</td></tr>\n",
                            m.beaten_by ? fmt::format("beaten by {}", *m.beaten_by + 1)
                                        : "<span class=\"badge agrees\">frontier</span>");
    }
    return html + "</tbody></table></div>\n";
}

std::string legend(const TradeOffReport& r) {
    std::map<std::string, Knob> groups;
    for (const Measurement& m : r.settings)
        groups.try_emplace(group_of(m.setting.knob).name, m.setting.knob);
    std::string html = "<ul class=\"legend\">";
    for (const auto& [name, knob] : groups)
        html += fmt::format("<li>{} {}</li>", scatter_key(knob), escaped(name));
    return html + "<li class=\"soft\">hollow: beaten</li></ul>";
}

std::string section(const TradeOffReport& r, std::size_t scene, const std::string& plot) {
    const std::string prefix = fmt::format("s{}-", scene);
    std::string html = fmt::format("<article data-name=\"{0}\"><h2>{0}</h2>\n<ul class=\"advice\">",
                                   escaped(r.scene));
    for (const Advice& a : r.advice) {
        const std::string text = escaped(sentence(a, r.settings));
        html += a.use ? fmt::format("<li><a href=\"#{}{}\" data-setting=\"{}\">{}</a></li>", prefix,
                                    *a.use, *a.use, text)
                      : "<li>" + text + "</li>";
    }
    html += fmt::format(
        "</ul>\n<p class=\"soft\">{}x{} pixels, {} thread{}. Truth: {} rays a pixel, its own error "
        "about {}{}; {}. {}</p>\n",
        r.width(), r.height(), r.threads, r.threads == 1 ? "" : "s", r.truth_points,
        shown(r.truth_error, 2),
        r.is_truth_rough() ? ", more than a third of the smallest error here" : "",
        truth_cut_words(r), "C" + cost_words(r).substr(1) + ".");
    html += "<div class=\"plot\"><div>" + scatter_for_page(r, prefix) + legend(r) +
            fmt::format("<p class=\"soft\"><a href=\"{}\">The plot as SVG</a></p></div>",
                        url_of(plot)) +
            "<div class=\"details\" aria-live=\"polite\">\n";
    for (std::size_t i = 0; i < r.settings.size(); ++i) html += detail(r, i, prefix);
    html += picture(r.truth_png, r, "Truth") + "</div></div>\n" + table(r, prefix);
    if (!r.left_out.empty()) {
        html += "<h3>Left out</h3><ul>";
        for (const LeftOut& l : r.left_out)
            html += fmt::format("<li>{}: {}</li>", escaped(l.setting), escaped(l.why));
        html += "</ul>";
    }
    return html + "</article>\n";
}

/// Drops pictures until the rest fits: the error maps of beaten settings, their pictures, then all
/// maps. Finally makes the remaining pictures coarser.
void fit(std::vector<TradeOffReport>& reports, std::size_t most_bytes) {
    const std::size_t most = most_bytes / 4 * 3;  // base64 makes four characters of three bytes
    const auto sum = [&] {
        std::size_t bytes = 0;
        for (const TradeOffReport& r : reports) {
            bytes += r.truth_png.size();
            for (const Measurement& m : r.settings)
                bytes +=
                    m.png.size() + m.error_png.size() + m.guessed_png.size() + m.samples_png.size();
        }
        return bytes;
    };
    const auto drop = [&](bool beaten_alone, auto what) {
        if (sum() <= most) return;
        for (TradeOffReport& r : reports)
            for (Measurement& m : r.settings)
                if (m.beaten_by || !beaten_alone) (m.*what).clear();
    };
    drop(true, &Measurement::guessed_png);
    drop(true, &Measurement::samples_png);
    drop(true, &Measurement::error_png);
    drop(true, &Measurement::png);
    drop(false, &Measurement::guessed_png);
    drop(false, &Measurement::samples_png);
    drop(false, &Measurement::error_png);
    std::size_t pictures = 1;
    if (sum() <= most) return;
    for (const TradeOffReport& r : reports) pictures += r.settings.size() + 1;
    const auto shrunk = [&](std::string& png) {
        if (png.size() <= most / pictures) return;
        Preview preview{png, 0, 0};
        shrink(preview, most / pictures);
        png = preview.png;
    };
    for (TradeOffReport& r : reports) {
        shrunk(r.truth_png);
        for (Measurement& m : r.settings) shrunk(m.png);
    }
}

}  // namespace

std::vector<std::string> plot_names(const std::vector<std::string>& scenes) {
    if (scenes.size() == 1) return {"plot.svg"};
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const std::string& scene : scenes) {
        const std::string stem = slug(std::filesystem::path(scene).stem().string());
        std::string name = "plot-" + stem + ".svg";
        for (int copy = 2; !taken.insert(name).second; ++copy)
            name = fmt::format("plot-{}-{}.svg", stem, copy);
        names.push_back(name);
    }
    return names;
}

std::string tradeoff_page(std::vector<TradeOffReport> reports, std::size_t most_bytes) {
    fit(reports, most_bytes);
    std::vector<std::string> scenes;
    scenes.reserve(reports.size());
    for (const TradeOffReport& r : reports) scenes.push_back(r.scene);
    const std::vector<std::string> plots = plot_names(scenes);
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
        "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta "
        "name=\"generator\" content=\"{}\">\n<title>Speed for accuracy</title>\n<style>\n{}{}"
        "</style>\n</head>\n<body>\n<header><div><h1>Speed for accuracy</h1><p>What each setting "
        "costs, and how far its picture is from the truth. <button id=\"theme\" title=\"Light or "
        "dark\">◐</button></p></div></header>\n<main>\n",
        tradeoff_mark, page_style, tradeoff_style);
    for (std::size_t i = 0; i < reports.size(); ++i) html += section(reports[i], i, plots[i]);
    html +=
        "</main>\n<footer><main><p>Point at a dot or a line of the table, or go to a dot by Tab "
        "and on by <kbd>←</kbd> <kbd>→</kbd>; <kbd>↑</kbd> <kbd>↓</kbd> stay on the frontier. "
        "Pictures on this page have 8 bits a channel; all numbers were computed from the "
        "originals.</p></main></footer>\n<script>\n";
    return html + std::string(tradeoff_script) + "</script>\n</body>\n</html>\n";
}

void write_tradeoff(std::vector<TradeOffReport> reports, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw FileError(fmt::format("cannot make the folder '{}': {}", folder, error.message()));
    std::vector<std::string> scenes;
    scenes.reserve(reports.size());
    for (const TradeOffReport& r : reports) scenes.push_back(r.scene);
    const std::vector<std::string> plots = plot_names(scenes);
    for (std::size_t i = 0; i < reports.size(); ++i)
        io::write_file(folder + "/" + plots[i], scatter_document(reports[i]));
    io::write_file(folder + "/index.html", tradeoff_page(std::move(reports)));
}

}  // namespace lancer::judge
