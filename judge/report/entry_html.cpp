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

/// More circles hide the picture. The first ones are the largest differences.
constexpr std::size_t most_circles = 60;
/// The number of lines in the list of the worst pixels.
constexpr std::size_t most_listed = 12;

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
    const double radius = std::max(2.5, entry.heat.width / 90.0);
    for (std::size_t i = 0; i < std::min(entry.markers.size(), most_circles); ++i) {
        const Marker& m = entry.markers[i];
        const std::string ring =
            fmt::format("cx=\"{}.5\" cy=\"{}.5\" r=\"{:.1f}\"", m.x, m.y, radius);
        svg += fmt::format(
            "<circle class=\"halo\" {0}/><circle class=\"k-{1}\" data-pixel=\"{2},{3}\" "
            "{0}><title>{4}</title></circle>",
            ring, slug(m.kind), m.x, m.y, escaped(m.text));
    }
    return svg + "</svg>";
}

/// The legend below the heat map: its colours with numbers, and the meaning of the circles.
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
        html += fmt::format("<li><span class=\"dot k-{}\"></span>{}: {}</li>", slug(kind),
                            escaped(kind), count);
    }
    html += "</ul>";
    if (entry.markers.size() > most_circles)
        html += fmt::format("<p class=\"soft\">The {} largest are circled.</p>", most_circles);
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
            "<figcaption>Largest difference of a channel, linear light, logarithmic{}</figcaption>"
            "</figure>",
            picture(entry.heat, "Difference: " + entry.name), circles(entry), heat_legend(entry),
            entry.markers.empty() ? ""
                                  : " <label class=\"rings\"><input type=\"checkbox\" checked> "
                                    "rings</label>");
    }
    html += "</div>";
    if (heat) {
        html +=
            "<input class=\"split\" type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
            "aria-label=\"Where the pictures meet\">";
    }
    return html;
}

std::string channels(const Color& c) {
    return fmt::format("{:.6f} {:.6f} {:.6f}", c.x, c.y, c.z);
}

/// The page's script fills this in: both pictures around a place, and their values there.
std::string loupe(const ReportEntry& entry, const Report& report) {
    if (entry.heat.png.empty()) return {};
    std::string html = fmt::format(
        "<div class=\"loupe\" data-width=\"{}\" data-height=\"{}\"><p class=\"soft at\">Point at a "
        "picture to see the values there; click to keep the place.</p>",
        entry.left.width, entry.left.height);
    for (const auto& [side, name] :
         {std::pair{"left", report.left_name}, {"right", report.right_name}})
        html += fmt::format(
            "<div class=\"glass {}\" hidden><canvas width=\"110\" height=\"110\"></canvas>"
            "<div><b>{}</b><output></output></div></div>",
            side, escaped(name));
    html +=
        "<div class=\"glass change\" hidden><div><b>Difference</b><output></output></div></div>";
    const auto values = [&](const char* side, const ExactValues& v) {
        for (const auto& [part, png] : {std::pair{"high", &v.high}, {"low", &v.low}})
            html += fmt::format(
                "<img hidden alt=\"\" class=\"{}-{}\" src=\"data:image/png;base64,{}\">", side,
                part, base64(*png));
    };
    if (!entry.left_values.high.empty() && !entry.right_values.high.empty()) {
        values("left", entry.left_values);
        values("right", entry.right_values);
    }
    return html + "</div>";
}

std::string worst_pixels(const ReportEntry& entry, const Report& report, std::size_t rank) {
    if (entry.markers.empty()) return {};
    std::string html = fmt::format(
        "<h3>Worst pixels</h3><div class=\"table\"><table class=\"worst\"><thead><tr><th>Place</th>"
        "<th class=\"number\">Difference</th><th>What it is</th><th class=\"number\">{}</th>"
        "<th class=\"number\">{}</th></tr></thead><tbody>",
        escaped(report.left_name), escaped(report.right_name));
    for (std::size_t i = 0; i < std::min(entry.markers.size(), most_listed); ++i) {
        const Marker& m = entry.markers[i];
        html += fmt::format(
            "<tr><td><a href=\"#{0}\" data-pixel=\"{1},{2}\" title=\"{7}\">{1}, {2}</a></td><td "
            "class=\"number\">{3:.3g}</td><td>{4}</td><td class=\"number\">{5}</td><td "
            "class=\"number\">{6}</td></tr>",
            entry_id(rank), m.x, m.y, m.difference, escaped(m.kind), channels(m.left),
            channels(m.right), escaped(m.text));
    }
    html += "</tbody></table></div>";
    if (entry.markers.size() > most_listed)
        html += fmt::format("<p class=\"soft\">{} more.</p>", entry.markers.size() - most_listed);
    return html;
}

std::string file_links(const ReportEntry& entry) {
    if (entry.files.empty()) return {};
    std::string html = "<p class=\"files\">Beside this page:";
    for (const ReportFile& file : entry.files)
        html +=
            fmt::format(" <a href=\"{}\">{}</a>", escaped(url_of(file.name)), escaped(file.label));
    return html + "</p>";
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

/// The text that the page's search examines.
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
    if (!entry.summary.empty()) html += "<p class=\"summary\">" + escaped(entry.summary) + "</p>";
    if (!entry.left.png.empty() || !entry.right.png.empty())
        html += viewer(entry, report) + loupe(entry, report);
    if (!entry.reasons.empty()) {
        html += fmt::format("<ul class=\"reasons {}\">", verdict);
        for (const std::string& reason : entry.reasons) html += "<li>" + escaped(reason) + "</li>";
        html += "</ul>";
    }
    html += worst_pixels(entry, report, rank);
    if (!entry.measures.empty()) {
        html += "<div class=\"facts\"><div>" + measure_table(entry) + "</div><div>";
        if (!entry.differences.empty()) {
            html += "<h3>Pixels by difference, both axes logarithmic</h3>" +
                    histogram_svg(entry.differences, report.histogram_marks);
        }
        html += "</div></div>";
    }
    return html + note_list(entry.notes) + file_links(entry) + evidence(entry) + "</article>\n";
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
