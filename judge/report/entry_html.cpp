#include "judge/report/entry_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "judge/report/histogram.h"
#include "judge/report/html.h"
#include "reference/compare/color_map.h"

namespace lancer::judge {

namespace {

/// More circles than this hide the picture; the first ones are the largest differences.
constexpr std::size_t most_markers = 400;

std::string entry_id(std::size_t rank) {
    return fmt::format("pair-{}", rank);
}

std::string picture(const Preview& preview, const std::string& alt) {
    if (preview.png.empty()) return "<div class=\"missing\">no picture</div>";
    return fmt::format(
        "<img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">",
        escaped(alt), preview.width, preview.height, base64(preview.png));
}

std::string circles(const ReportEntry& entry) {
    if (entry.markers.empty()) return {};
    std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" preserveAspectRatio=\"none\">",
                                  entry.heat.width, entry.heat.height);
    // Few are pointed at from afar, many only marked.
    const double radius =
        std::max(2.5, entry.heat.width / 110.0) * (entry.markers.size() > 100 ? 0.4 : 1.0);
    for (std::size_t i = 0; i < std::min(entry.markers.size(), most_markers); ++i) {
        const Marker& m = entry.markers[i];
        svg += fmt::format(
            "<circle class=\"k-{}\" cx=\"{}.5\" cy=\"{}.5\" "
            "r=\"{:.1f}\"><title>{}</title></circle>",
            slug(m.kind), m.x, m.y, radius, escaped(m.text));
    }
    return svg + "</svg>";
}

/// Below the heat map: its colours with numbers, and what the circles stand for.
std::string heat_legend(const ReportEntry& entry) {
    const auto srgb = [](double v) {
        const double encoded =
            v <= 0.0031308 ? 12.92 * v : 1.055 * elementary::pow(v, 1 / 2.4) - 0.055;
        return std::lround(std::clamp(encoded, 0.0, 1.0) * 255);
    };
    std::string html = "<div class=\"scale\" style=\"background:linear-gradient(to right";
    for (int i = 0; i <= 10; ++i) {
        const Color c = reference::magma(i / 10.0);
        html += fmt::format(",#{:02x}{:02x}{:02x}", srgb(c.x), srgb(c.y), srgb(c.z));
    }
    html +=
        ")\"></div><div class=\"ticks\"><span>1e-6</span><span>1e-5</span><span>1e-4</span>"
        "<span>1e-3</span><span>0.01</span><span>0.1</span><span>1</span></div>";
    std::map<std::string, std::size_t> kinds;
    for (const Marker& m : entry.markers) ++kinds[m.kind];
    if (kinds.empty()) return html;
    html += "<ul class=\"legend\">";
    for (const auto& [kind, count] : kinds) {
        html += fmt::format("<li><span class=\"dot k-{}\"></span>{} {}</li>", slug(kind),
                            escaped(kind), count);
    }
    html += "</ul>";
    if (entry.markers.size() > most_markers) {
        html += fmt::format("<p class=\"soft\">The {} largest are circled.</p>", most_markers);
    }
    return html;
}

std::string viewer(const ReportEntry& entry, const Report& report) {
    const bool heat = !entry.heat.png.empty();
    std::string html =
        fmt::format("<div class=\"viewer{}\" data-mode=\"side\">", heat ? "" : " two");
    html += fmt::format(
        "<figure class=\"left\"><div class=\"frame stack\">{}</div><figcaption>{}</figcaption>"
        "</figure>",
        picture(entry.left, report.left_name + ": " + entry.name), escaped(report.left_name));
    html += fmt::format(
        "<figure class=\"right\"><div class=\"frame stack\">{}<span class=\"divider\"></span></div>"
        "<figcaption>{}</figcaption></figure>",
        picture(entry.right, report.right_name + ": " + entry.name), escaped(report.right_name));
    if (heat) {
        html += fmt::format(
            "<figure class=\"heat\"><div class=\"frame\">{}{}</div>{}"
            "<figcaption>Largest difference of a channel, linear light, logarithmic</figcaption>"
            "</figure>",
            picture(entry.heat, "Difference: " + entry.name), circles(entry), heat_legend(entry));
    }
    html += "</div>";
    if (heat) {
        html +=
            "<input class=\"split\" type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
            "aria-label=\"Where the pictures meet\">";
    }
    return html;
}

std::string measure_table(const ReportEntry& entry) {
    if (entry.measures.empty()) return {};
    std::string html =
        "<table><thead><tr><th>Measure</th><th class=\"number\">Achieved</th>"
        "<th class=\"number\">Threshold</th><th></th></tr></thead><tbody>";
    for (const Measure& m : entry.measures) {
        const char* mark = m.threshold.empty() ? ""
                           : m.ok              ? "<span class=\"yes\" title=\"met\">✓</span>"
                                               : "<span class=\"no\" title=\"missed\">✗</span>";
        html += fmt::format(
            "<tr{}><td>{}</td><td class=\"number\">{}</td><td "
            "class=\"number\">{}</td><td>{}</td></tr>",
            m.ok ? "" : " class=\"bad\"", escaped(m.name), escaped(m.achieved),
            escaped(m.threshold), mark);
    }
    return html + "</tbody></table>";
}

std::string note_list(const std::vector<Note>& notes) {
    if (notes.empty()) return {};
    std::string html = "<dl>";
    for (const Note& note : notes) {
        html += fmt::format("<dt>{}</dt><dd>{}</dd>", escaped(note.label), escaped(note.text));
    }
    return html + "</dl>";
}

std::string evidence(const ReportEntry& entry) {
    if (entry.evidence.empty()) return {};
    std::string html = "<details><summary>Commands, versions and how to repeat this</summary>";
    for (const Note& note : entry.evidence) {
        html += fmt::format("<h3>{}</h3><pre>{}</pre>", escaped(note.label), escaped(note.text));
    }
    return html + "</details>";
}

/// What the search looks at.
std::string searchable(const ReportEntry& entry) {
    std::string text = entry.name + ' ' + verdict_name(entry.verdict);
    for (const std::string& reason : entry.reasons) text += ' ' + reason;
    for (const Marker& m : entry.markers) {
        if (text.find(m.kind) == std::string::npos) text += ' ' + m.kind;
    }
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

double largest_of(const ReportEntry& entry) {
    if (entry.differences.empty()) return 0;
    return *std::max_element(entry.differences.begin(), entry.differences.end());
}

std::string seconds(double value) {
    return value > 0 ? fmt::format("{:.2f} s", value) : "–";
}

}  // namespace

std::string verdict_name(Verdict verdict) {
    switch (verdict) {
        case Verdict::failed:
            return "failed";
        case Verdict::differs:
            return "differs";
        case Verdict::refused:
            return "refused";
        case Verdict::agrees:
            return "agrees";
    }
    return {};
}

std::string entry_card(const ReportEntry& entry, const Report& report, std::size_t rank) {
    const std::string verdict = verdict_name(entry.verdict);
    std::string html = fmt::format(
        "<article id=\"{}\" tabindex=\"-1\" data-rank=\"{}\" data-name=\"{}\" data-verdict=\"{}\" "
        "data-largest=\"{:g}\" data-seconds=\"{:g}\" data-text=\"{}\">",
        entry_id(rank), rank, escaped(entry.name), verdict, largest_of(entry),
        entry.left_seconds + entry.right_seconds, escaped(searchable(entry)));
    html += fmt::format("<div class=\"head\"><h2>{}</h2><span class=\"badge {}\">{}</span>",
                        escaped(entry.name), verdict, verdict);
    if (entry.left_seconds > 0 || entry.right_seconds > 0) {
        html += fmt::format("<span class=\"soft\">{} {} · {} {}</span>", escaped(report.left_name),
                            seconds(entry.left_seconds), escaped(report.right_name),
                            seconds(entry.right_seconds));
    }
    if (!entry.heat.png.empty()) {
        html +=
            "<span class=\"buttons\"><button data-set=\"side\" aria-pressed=\"true\">Side by side"
            "</button><button data-set=\"slider\" aria-pressed=\"false\">Slider</button>"
            "<button data-set=\"blink\" aria-pressed=\"false\">Blink</button></span>";
    }
    html += "</div>";
    if (!entry.reasons.empty()) {
        html += fmt::format("<ul class=\"reasons {}\">", verdict);
        for (const std::string& reason : entry.reasons) html += "<li>" + escaped(reason) + "</li>";
        html += "</ul>";
    }
    if (!entry.left.png.empty() || !entry.right.png.empty()) html += viewer(entry, report);
    if (!entry.measures.empty()) {
        html += "<div class=\"facts\"><div>" + measure_table(entry) + "</div><div>";
        if (!entry.differences.empty()) {
            html += "<h3>Pixels by difference, both axes logarithmic</h3>" +
                    histogram_svg(entry.differences, report.histogram_marks);
        }
        html += "</div></div>";
    }
    return html + note_list(entry.notes) + evidence(entry) + "</article>\n";
}

std::string entry_row(const ReportEntry& entry, const Report& report, std::size_t rank) {
    const std::string verdict = verdict_name(entry.verdict);
    std::string html = fmt::format(
        "<tr data-for=\"{0}\"><td><a href=\"#{0}\">{1}</a></td>"
        "<td><span class=\"badge {2}\">{2}</span></td>",
        entry_id(rank), escaped(entry.name), verdict);
    for (std::size_t i = 0; i < report.columns.size(); ++i) {
        const std::string cell = i < entry.cells.size() ? entry.cells[i] : "–";
        html += fmt::format("<td class=\"number\">{}</td>", escaped(cell));
    }
    return html + "</tr>\n";
}

}  // namespace lancer::judge
