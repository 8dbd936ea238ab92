#include "judge/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "judge/report/entry_html.h"
#include "judge/report/html.h"
#include "judge/report/page_assets.h"
#include "model/diagnostic.h"
#include "model/io/file.h"

namespace lancer::judge {

namespace {

constexpr Verdict all_verdicts[] = {Verdict::failed, Verdict::differs, Verdict::refused,
                                    Verdict::agrees};

std::size_t count(const std::vector<ReportEntry>& entries, Verdict verdict) {
    return static_cast<std::size_t>(
        std::count_if(entries.begin(), entries.end(),
                      [&](const ReportEntry& e) { return e.verdict == verdict; }));
}

std::string head(const Report& report) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n",
        escaped(report.title), page_style);
}

std::string introduction(const Report& report) {
    std::string html = fmt::format("<header><div><h1>{}</h1>\n", escaped(report.title));
    html += "<ul class=\"tally\">";
    for (const Verdict verdict : all_verdicts) {
        const std::size_t n = count(report.entries, verdict);
        if (n == 0) continue;
        std::string word = verdict_name(verdict);
        if (n != 1 && word.ends_with('s')) word.pop_back();  // 4 agree, 1 agrees
        html += fmt::format("<li class=\"badge {}\">{} {}</li>", verdict_name(verdict), n, word);
    }
    return html + "</ul>\n</div></header>\n";
}

std::string about(const Report& report) {
    if (report.about.empty()) return {};
    std::string html = "<section><h2>What is compared, and how</h2><dl>";
    for (const Note& note : report.about)
        html += fmt::format("<dt>{}</dt><dd>{}</dd>", escaped(note.label), escaped(note.text));
    return html + "</dl></section>\n";
}

std::string controls(const Report& report) {
    std::string html =
        "<div id=\"bar\"><div style=\"max-width:1240px;margin:0 auto;padding-left:1.25rem;"
        "padding-right:1.25rem\"><input id=\"search\" type=\"search\" "
        "placeholder=\"Filter by name, verdict or reason  ( / )\" aria-label=\"Filter\">"
        "<span class=\"buttons\"><button data-verdict-filter=\"all\" aria-pressed=\"true\">All"
        "</button>";
    for (const Verdict verdict : all_verdicts) {
        const std::size_t n = count(report.entries, verdict);
        if (n == 0) continue;
        html += fmt::format(
            "<button data-verdict-filter=\"{0}\" aria-pressed=\"false\">{0} {1}</button>",
            verdict_name(verdict), n);
    }
    return html +
           "</span><label class=\"soft\">Order <select id=\"sort\">"
           "<option value=\"urgency\">what needs looking at first</option>"
           "<option value=\"name\">name</option><option value=\"largest\">largest "
           "difference</option>"
           "<option value=\"seconds\">time</option></select></label>"
           "<span id=\"shown\" class=\"soft\" aria-live=\"polite\"></span>"
           "<button id=\"theme\" title=\"Light or dark\">◐</button></div></div>\n";
}

std::string overview(const Report& report, const std::vector<const ReportEntry*>& ordered) {
    std::string html =
        "<div class=\"table\"><table id=\"overview\"><thead><tr><th>Pair</th><th>Verdict</th>";
    for (const std::string& column : report.columns) {
        html += fmt::format("<th class=\"number\">{}</th>", escaped(column));
    }
    html += "</tr></thead><tbody>\n";
    for (std::size_t i = 0; i < ordered.size(); ++i) html += entry_row(*ordered[i], report, i + 1);
    return html + "</tbody></table></div>\n";
}

constexpr const char* keys_help =
    "<footer><p>Keys: <kbd>/</kbd> filter, <kbd>j</kbd> <kbd>k</kbd> next and previous pair, "
    "<kbd>1</kbd> side by side, <kbd>2</kbd> slider (drag, or <kbd>←</kbd> <kbd>→</kbd>), "
    "<kbd>3</kbd> blink, <kbd>r</kbd> rings on and off. Circles and bars say more when pointed at. "
    "Pictures on this page have 8 "
    "bits "
    "per channel; all numbers were computed from the originals.</p></footer>\n";

}  // namespace

void sort_markers(std::vector<Marker>& markers) {
    std::stable_sort(markers.begin(), markers.end(), [](const Marker& a, const Marker& b) {
        const bool unexplained = a.kind == "unexplained";
        if (unexplained != (b.kind == "unexplained")) return unexplained;
        return a.difference > b.difference;
    });
}

namespace {

/// Limits the exact values, and returns what remains of `most_bytes`, in bytes before base64.
std::size_t fit_values(Report& report, std::size_t most_bytes) {
    std::vector<ReportEntry*> entries;
    std::size_t all = 0;
    const auto bytes = [](const ReportEntry& e) {
        return e.left_values.bytes() + e.right_values.bytes();
    };
    for (ReportEntry& entry : report.entries) {
        all += bytes(entry);
        entries.push_back(&entry);
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [&](const auto* a, const auto* b) { return bytes(*a) > bytes(*b); });
    for (ReportEntry* entry : entries) {
        if (all <= most_bytes / 2) break;
        all -= bytes(*entry);
        entry->left_values = entry->right_values = {};
    }
    return most_bytes - all;
}

}  // namespace

void fit(Report& report, std::size_t most_bytes) {
    std::vector<Preview*> previews;
    for (ReportEntry& entry : report.entries) {
        for (Preview* p : {&entry.left, &entry.right, &entry.heat}) {
            if (!p->png.empty()) previews.push_back(p);
        }
    }
    // Finds the limit for which all previews would just fit if the larger ones were cut to it.
    std::sort(previews.begin(), previews.end(),
              [](const Preview* a, const Preview* b) { return a->png.size() < b->png.size(); });
    // base64 makes four characters of three bytes.
    std::size_t left = fit_values(report, most_bytes / 4 * 3);
    for (std::size_t i = 0; i < previews.size(); ++i) {
        const std::size_t limit = left / (previews.size() - i);
        if (previews[i]->png.size() > limit) shrink(*previews[i], limit);
        left -= std::min(left, previews[i]->png.size());
    }
}

std::string to_html(const Report& report) {
    std::vector<const ReportEntry*> ordered;
    for (const ReportEntry& entry : report.entries) ordered.push_back(&entry);
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const ReportEntry* a, const ReportEntry* b) {
                         if (a->verdict != b->verdict) return a->verdict < b->verdict;
                         return a->urgency > b->urgency;
                     });
    // For a single pair there is no list: its verdict and its pictures come first.
    std::string html =
        head(report) + fmt::format("<div class=\"{}\">\n", ordered.size() == 1 ? "one" : "many") +
        introduction(report) + controls(report) + "<main>\n" + overview(report, ordered);
    html += "<section aria-label=\"Pairs\">\n";
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        html += entry_card(*ordered[i], report, i + 1);
    }
    html += "</section>\n";
    html += about(report);
    html += keys_help;
    html += fmt::format("</main>\n</div>\n<script>\n{}</script>\n</body>\n</html>\n", page_script);
    return html;
}

void write_report(Report report, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder)) {
        throw FileError(
            fmt::format("cannot make the folder '{}': {}", folder,
                        error ? error.message() : "something that is not a folder has this name"));
    }
    fit(report, report_bytes);
    for (const ReportEntry& entry : report.entries)
        for (const ReportFile& file : entry.files)
            io::write_file((std::filesystem::path(folder) / file.name).string(), file.bytes);
    io::write_file((std::filesystem::path(folder) / "index.html").string(), to_html(report));
}

}  // namespace lancer::judge
