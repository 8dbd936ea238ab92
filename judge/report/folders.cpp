#include "judge/report/folders.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

#include "judge/report/entry_html.h"
#include "model/diagnostic.h"
#include "model/io/image_file.h"
#include "reference/compare/comparison_text.h"
#include "reference/compare/heat_map.h"

namespace lancer::judge {

namespace {

namespace fs = std::filesystem;

ReportEntry failed_entry(const std::string& name, const std::string& reason) {
    ReportEntry entry;
    entry.name = name;
    entry.verdict = Verdict::failed;
    entry.reasons = {reason};
    return entry;
}

void add_measures(ReportEntry& entry, const reference::Comparison& c,
                  const reference::CompareOptions& options) {
    const auto plain = [&](std::string name, double value) {
        entry.measures.push_back({std::move(name), fmt::format("{:.4g}", value), "", true});
    };
    entry.measures.push_back({fmt::format("Pixels over {:g}", options.fail),
                              fmt::format("{:.4g} %", c.over * 100),
                              fmt::format("≤ {:g} %", options.fail_percent), c.pass});
    if (c.over_at_edges > 0) {
        entry.measures.push_back(
            {options.edges_may_move ? "… at an edge, which is allowed" : "… at an edge",
             std::to_string(c.over_at_edges), "", true});
    }
    if (const reference::Window& w = c.densest; w.flagged > 0) {
        entry.measures.push_back(
            {fmt::format("… in the {} x {} pixels from ({}, {}) on", w.width, w.height, w.x, w.y),
             fmt::format("{:.4g} %", w.share() * 100),
             options.fail_window < 100 ? fmt::format("≤ {:g} %", options.fail_window) : "",
             w.share() * 100 <= options.fail_window});
    }
    plain("Largest difference", c.max);
    plain("99.9 % of the pixels", c.p999);
    plain("99 % of the pixels", c.p99);
    plain("Mean difference", c.mean);
    plain("RMSE", c.rmse);
    if (c.rmse > 0) plain("PSNR, dB", c.psnr);
    if (options.flip) plain("FLIP", c.flip);
}

/// Marks the largest differences.
void add_markers(ReportEntry& entry, const Image& a, const Image& b,
                 const reference::CompareOptions& options) {
    constexpr std::size_t most = 500;
    const auto& differences = entry.differences;
    std::vector<std::size_t> over;
    for (std::size_t i = 0; i < differences.size(); ++i)
        if (differences[i] > options.fail) over.push_back(i);
    const auto larger = [&](std::size_t i, std::size_t j) {
        return differences[i] != differences[j] ? differences[i] > differences[j] : i < j;
    };
    const std::size_t kept = std::min(most, over.size());
    std::partial_sort(over.begin(), over.begin() + static_cast<std::ptrdiff_t>(kept), over.end(),
                      larger);
    over.resize(kept);
    const auto color = [](const Image& image, int x, int y) {
        const double* p = image.pixel(x, y);
        return image.channels < 3 ? Color(p[0]) : Color(p[0], p[1], p[2]);
    };
    const auto width = static_cast<std::size_t>(a.width);
    for (const std::size_t i : over) {
        const int x = static_cast<int>(i % width);
        const int y = static_cast<int>(i / width);
        entry.markers.push_back({x, y, "over",
                                 fmt::format("({}, {}) differs by {:.3g}", x, y, differences[i]),
                                 differences[i], color(a, x, y), color(b, x, y)});
    }
}

}  // namespace

std::set<std::string> pictures_in(const std::string& folder) {
    std::set<std::string> names;
    std::error_code error;
    fs::recursive_directory_iterator at(folder, error);
    if (error) throw FileError(fmt::format("cannot list '{}': {}", folder, error.message()));
    for (; at != fs::recursive_directory_iterator(); at.increment(error)) {
        if (error) throw FileError(fmt::format("cannot list '{}': {}", folder, error.message()));
        const std::string path = at->path().string();
        if (at->is_regular_file(error) && io::is_writable_image_name(path)) {
            names.insert(at->path().lexically_relative(folder).string());
        }
    }
    return names;
}

ReportEntry pair_entry(const std::string& name, const Image& a, const Image& b,
                       const reference::Comparison& comparison,
                       const reference::CompareOptions& options);

ReportEntry pair_entry(const std::string& name, const Image& a, const Image& b,
                       const reference::CompareOptions& options) {
    return pair_entry(name, a, b, reference::compare_images(a, b, options), options);
}

ReportEntry pair_entry(const std::string& name, const Image& a, const Image& b,
                       const reference::Comparison& comparison,
                       const reference::CompareOptions& options) {
    ReportEntry entry;
    entry.name = name;
    entry.verdict = comparison.pass ? Verdict::agrees : Verdict::differs;
    if (!comparison.pass) entry.reasons.push_back(comparison.reason);
    entry.left = preview_of(a);
    entry.right = preview_of(b);
    if (comparison.comparable) {
        entry.differences = reference::counted_differences(a, b, options.counted);
        entry.heat = preview_of(reference::heat_map(entry.differences, a.width, false));
        entry.urgency = comparison.over * 1e3 + comparison.max;
        entry.left_values = exact_values(a);
        entry.right_values = exact_values(b);
        add_markers(entry, a, b, options);
        add_measures(entry, comparison, options);
        entry.cells = {
            fmt::format("{:.3g}", comparison.max), fmt::format("{:.3g}", comparison.mean),
            fmt::format("{:.3g} %", comparison.over * 100), fmt::format("{:.3g}", comparison.flip)};
    }
    return entry;
}

FolderComparison compare_folders(const std::string& a, const std::string& b,
                                 const reference::CompareOptions& options,
                                 const std::function<void(const ReportEntry&)>& on_pair,
                                 const MaskOf& mask_of) {
    const std::set<std::string> names_a = pictures_in(a);
    const std::set<std::string> names_b = pictures_in(b);
    std::set<std::string> names = names_a;
    names.insert(names_b.begin(), names_b.end());
    if (names.empty()) throw FileError(fmt::format("there is no picture in '{}' or '{}'", a, b));

    FolderComparison result;
    result.pass = true;
    result.report.title = fmt::format("{} against {}", a, b);
    result.report.left_name = a;
    result.report.right_name = b;
    result.report.columns = {"Largest", "Mean", fmt::format("Over {:g}", options.fail), "FLIP"};
    result.report.about = {
        {"Comparison",
         fmt::format("Pictures of the same name are compared in linear light: 8-bit files are "
                     "decoded with the sRGB curve, 16-bit PNG files as they say themselves, EXR "
                     "and HDR files are linear. A pixel is over when a channel differs by more "
                     "than {:g}; a pair differs when more than {:g} % of its pixels are over.{}",
                     options.fail, options.fail_percent,
                     options.edges_may_move
                         ? " A pixel is not counted when one of the pictures has an edge there, "
                           "and each picture's value occurs in the other within one pixel."
                         : "")}};
    if (options.fail > 0) result.report.histogram_marks = {options.fail};
    for (const std::string& name : names) {
        ReportEntry entry;
        std::optional<reference::Comparison> measures;
        if (!names_b.contains(name)) {
            entry = failed_entry(name, fmt::format("only in '{}'", a));
        } else if (!names_a.contains(name)) {
            entry = failed_entry(name, fmt::format("only in '{}'", b));
        } else {
            try {
                const Image left = io::read_image((fs::path(a) / name).string());
                const Image right = io::read_image((fs::path(b) / name).string());
                reference::CompareOptions chosen = options;
                if (mask_of) chosen.counted = mask_of(name);
                measures = reference::compare_images(left, right, chosen);
                entry = pair_entry(name, left, right, *measures, chosen);
            } catch (const FileError& error) {
                entry = failed_entry(name, error.what());
                ++result.unreadable;
            }
        }
        result.pass = result.pass && entry.verdict == Verdict::agrees;
        if (on_pair) on_pair(entry);
        result.pairs.push_back(
            {name, entry.verdict, entry.reasons.empty() ? "" : entry.reasons.front(), measures});
        result.report.entries.push_back(std::move(entry));
    }
    return result;
}

std::string to_json(const FolderComparison& comparison, const reference::CompareOptions& options) {
    nlohmann::ordered_json json;
    json["verdict"] = comparison.pass ? "pass" : "fail";
    json["pairs"] = nlohmann::ordered_json::array();
    for (const PairResult& pair : comparison.pairs) {
        nlohmann::ordered_json made;
        made["name"] = pair.name;
        made["verdict"] = verdict_name(pair.verdict);
        if (!pair.reason.empty()) made["reason"] = pair.reason;
        if (pair.measures)
            made["measures"] =
                nlohmann::ordered_json::parse(reference::to_json(*pair.measures, options));
        json["pairs"].push_back(std::move(made));
    }
    // File names may hold any bytes.
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::vector<JUnitCase> junit_cases(const FolderComparison& comparison) {
    std::vector<JUnitCase> cases;
    for (const PairResult& pair : comparison.pairs) {
        JUnitCase made{pair.name, 0, JUnitCase::Outcome::passed, {}};
        if (pair.verdict == Verdict::differs) made.outcome = JUnitCase::Outcome::failed;
        if (pair.verdict == Verdict::failed) made.outcome = JUnitCase::Outcome::error;
        if (!pair.reason.empty()) made.reasons.push_back(pair.reason);
        cases.push_back(std::move(made));
    }
    return cases;
}

}  // namespace lancer::judge
