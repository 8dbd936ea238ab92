#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "judge/report/html.h"
#include "judge/report/shell_text.h"
#include "judge/validate/validation_text.h"
#include "model/io/png_file.h"
#include "reference/compare/heat_map.h"

namespace lancer::judge {

namespace {

/// The largest number of pairs of coincident objects that a page lists.
constexpr std::size_t most_pairs_told = 20;

std::string percent(double share) {
    return fmt::format("{:.6g} %", share * 100);
}

void add_measures(ReportEntry& entry, const Validation& v) {
    const Judgement& j = v.judgement;
    const Thresholds& t = v.thresholds;
    const std::size_t unexplained = j.count(PixelClass::unexplained);
    const auto add = [&](std::string name, std::string achieved, std::string threshold, bool ok) {
        entry.measures.push_back({std::move(name), std::move(achieved), std::move(threshold), ok});
    };
    add(fmt::format("Unexplained, over {}", shown(t.interior)), std::to_string(unexplained),
        fmt::format("≤ {}", t.unexplained), unexplained <= t.unexplained);
    add(fmt::format("Away from edges, within {}", shown(t.tight)), percent(j.tight_share),
        "≥ " + percent(t.tight_share), j.tight_share >= t.tight_share);
    const double edges = static_cast<double>(std::max<std::size_t>(1, j.edge_pixels));
    const auto share_of_edges = [&](std::size_t n) {
        return fmt::format("{} of {}", n, j.edge_pixels);
    };
    const auto within = [&](std::size_t n, double share) {
        return n <= 1 || static_cast<double>(n) <= share * edges;
    };
    add("Explained, of the edge pixels", share_of_edges(j.explained),
        "≤ " + percent(t.explained_share), within(j.explained, t.explained_share));
    add(fmt::format("… by an edge off by {} pixel", shown(t.rounding)), share_of_edges(j.displaced),
        "≤ " + percent(t.displaced_share), within(j.displaced, t.displaced_share));
    if (v.picture.empty())
        add("Known differences, confirmed by POV-Ray's rule",
            std::to_string(j.count(PixelClass::known)), "", true);
    if (j.count(PixelClass::coincident) > 0)
        add("Coincident surfaces: when they are separated, POV-Ray has Lancer's value",
            std::to_string(j.count(PixelClass::coincident)), "", true);
    if (v.picture.empty())
        add("Outliers, which POV-Ray's own picture contradicts",
            fmt::format("{} of {}", j.count(PixelClass::outlier), j.pixels),
            "≤ " + percent(t.outlier_share), true);
    if (j.picture_shift.count > 0) {
        add("Shift of the picture, pixels",
            fmt::format("{} ± {}", shown(j.picture_shift.length(), 2),
                        shown(std::max(j.picture_shift.error_x, j.picture_shift.error_y), 1)),
            "≤ " + shown(t.shift), !j.picture_shift.is_significant(t.shift, 5));
    }
    if (j.edge_shift.count > 1) {
        add("Mean offset of these edges, pixels", shown(j.edge_shift.length(), 2),
            fmt::format("≤ {} or 3 σ", shown(t.rounding)),
            !j.edge_shift.is_significant(t.rounding, 3));
    }
    const auto plain = [&](std::string name, double value) {
        add(std::move(name), shown(value), "", true);
    };
    plain("Largest away from edges", j.interior_max);
    plain("99.9 % away from edges", j.interior_p999);
    plain("Largest anywhere", v.comparison.max);
    plain("Mean difference", v.comparison.mean);
    plain("RMSE", v.comparison.rmse);
    plain("FLIP", v.comparison.flip);
}

/// The rules that apply to the scene.
std::string rule_names(const std::vector<reference::KnownDifference>& known) {
    std::vector<std::string> names;
    for (const reference::KnownDifference& k : known) names.push_back(reference::rule_name(k.rule));
    return names.empty() ? "" : fmt::format(" ({})", fmt::join(names, ", "));
}

void add_markers(ReportEntry& entry, const Validation& v) {
    for (const DifferentPixel& p : v.judgement.different) {
        const std::string kind = class_name(p.pixel_class);
        std::string text = fmt::format(
            "({}, {}) {}: differs by {:.3g}; ours {:.6f} {:.6f} {:.6f}, theirs {:.6f} {:.6f} "
            "{:.6f}",
            p.x, p.y, kind, p.difference, p.ours.x, p.ours.y, p.ours.z, p.theirs.x, p.theirs.y,
            p.theirs.z);
        if (p.offset.x != 0 || p.offset.y != 0) {
            text += fmt::format("; edge at ({:.2g}, {:.2g}) pixel from the centre", p.offset.x,
                                p.offset.y);
        }
        if (p.pixel_class == PixelClass::outlier) text += "; POV-Ray has our value around it";
        if (p.pixel_class == PixelClass::known)
            text +=
                "; Lancer has POV-Ray's value by POV-Ray's rules" + rule_names(v.known_differences);
        if (p.pixel_class == PixelClass::coincident)
            text += "; POV-Ray has our value when coincident faces are separated";
        entry.markers.push_back({p.x, p.y, kind, std::move(text), p.difference, p.ours, p.theirs});
    }
    sort_markers(entry.markers);
}

/// The commands to repeat the validation; only the file names differ.
std::string commands_of(const Validation& v) {
    const std::string size = fmt::format("{}x{}", v.view.width, v.view.height);
    const std::string name = slug(v.name);
    if (!v.picture.empty()) {
        return fmt::format(
            "lancer render {0} --size {1} --samples 1 --min-contribution 0 -o {2}-ours.exr\n"
            "lancer compare {2}-ours.exr {3} --exposure {4} --fail {5:g} -o {2}-difference.png",
            v.scene_words, size, name, shell_quoted(v.picture), v.exposure, v.thresholds.interior);
    }
    std::vector<std::string> povray = reference::povray_arguments(v.view.width, v.view.height, 1);
    povray[0] = "+I" + name + ".pov";
    povray[1] = "+O" + name + ".png";
    return fmt::format(
        "lancer render {0} --size {1} --samples 1 --min-contribution 0 -o {2}-ours.exr\n"
        "lancer export {0} --size {1} --min-contribution 0 --exposure {3} -o {2}.pov\n"
        "povray {4}\n"
        "lancer compare {2}-ours.exr {2}.png --exposure {3} --fail {5:g} -o {2}-difference.png",
        v.scene_words, size, name, v.exposure, fmt::join(povray, " "), v.thresholds.interior);
}

/// One sentence: how many pixels agree, and the classes of the others.
std::string summary_of(const Validation& v) {
    const Judgement& j = v.judgement;
    std::vector<std::string> others;
    const auto add = [&](std::size_t n, const char* what) {
        if (n > 0) others.push_back(fmt::format("{} {}", n, what));
    };
    add(j.explained, j.explained == 1 ? "is on an edge" : "are on edges");
    add(j.count(PixelClass::known), "by a rule of POV-Ray's");
    add(j.count(PixelClass::coincident), "where surfaces coincide, shown by a second export");
    add(j.count(PixelClass::outlier), "that POV-Ray's own picture contradicts");
    add(j.count(PixelClass::unexplained), "unexplained");
    return fmt::format("{} of {} pixels agree to {}{}{}.", j.count(PixelClass::agrees), j.pixels,
                       shown(v.thresholds.interior), others.empty() ? "" : "; of the others ",
                       fmt::join(others, ", "));
}

/// Adds the exported scene and the pictures with full precision.
void add_files(ReportEntry& entry, const Validation& v) {
    const std::string name = slug(v.name);
    const auto add = [&](const std::string& file, const std::string& label, std::string bytes) {
        entry.files.push_back({file, label, std::move(bytes)});
    };
    if (!v.pov_text.empty()) add(name + ".pov", "scene for POV-Ray", v.pov_text);
    for (const reference::Asset& asset : v.pov_assets) add(asset.name, asset.name, asset.bytes);
    io::ImageWriteOptions deep;
    deep.bits = 16;
    if (!v.ours.data.empty())
        add(name + "-ours.png", "Lancer's picture", io::encode_png(v.ours, deep, name));
    if (!v.theirs.data.empty())
        add(name + "-theirs.png", v.picture.empty() ? "POV-Ray's picture" : "the other picture",
            io::encode_png(v.theirs, deep, name));
    if (!entry.heat.png.empty()) add(name + "-difference.png", "differences", entry.heat.png);
}

void add_notes(ReportEntry& entry, const Validation& v) {
    for (const reference::KnownDifference& known : v.known_differences) {
        entry.notes.push_back(
            {"Known difference: " + reference::rule_name(known.rule), known.explanation});
    }
    // Coincident opaque faces do not matter: no ray reaches them.
    std::vector<std::string> told;
    for (std::size_t i = 0; i < v.coincidences.size(); ++i)
        if (v.coincidences[i].resolution != reference::Coincidence::Resolution::hidden)
            told.push_back(v.coincidence_texts[i]);
    if (told.size() > most_pairs_told) {
        const std::size_t more = told.size() - most_pairs_told;
        told.resize(most_pairs_told);
        told.push_back(fmt::format("and {} more", more));
    }
    for (const std::string& text : told) entry.notes.push_back({"Coincident faces", text});
    for (const std::string& approximation : v.approximations) {
        entry.notes.push_back({"Approximated", approximation});
    }
    for (const std::string& expectation : v.expectations) {
        entry.notes.push_back({"Expected of this scene", expectation});
    }
    const std::string size = fmt::format("{}x{}", v.view.width, v.view.height);
    entry.evidence.push_back({"To repeat this", commands_of(v)});
    if (!v.picture.empty()) {
        entry.evidence.push_back(
            {"Circumstances", fmt::format("picture {} pixels\nread from {}\nlight in both "
                                          "pictures: {:g} times that of the scene",
                                          size, v.picture, v.exposure)});
        return;
    }
    std::string facts = fmt::format("picture {} pixels\nPOV-Ray {}\n", size, v.pov_version);
    if (v.pov_seconds > 0) {
        facts +=
            fmt::format("POV-Ray took {:.2f} s{}\n", v.pov_seconds,
                        v.from_cache ? ", when the picture was made; it is from the cache" : "");
    }
    facts += fmt::format(
        "lengths in the export: {:g} times those of the scene\nlight in both pictures: {:g} times "
        "that of the scene, so that no value is above 1",
        v.factor, v.exposure);
    entry.evidence.push_back({"Circumstances", std::move(facts)});
}

}  // namespace

ReportEntry report_entry(const Validation& v) {
    ReportEntry entry;
    entry.name = v.name;
    entry.verdict = v.verdict;
    entry.reasons = v.reasons;
    entry.left = preview_of(v.ours);
    entry.right = preview_of(v.theirs);
    entry.left_seconds = v.our_seconds;
    entry.right_seconds = v.pov_seconds;
    if (v.comparison.comparable) {
        entry.differences = reference::pixel_differences(v.ours, v.theirs);
        entry.heat = preview_of(reference::heat_map(entry.differences, v.ours.width, false));
        entry.left_values = exact_values(v.ours);
        entry.right_values = exact_values(v.theirs);
        entry.summary = summary_of(v);
        add_measures(entry, v);
        add_markers(entry, v);
        const auto seconds = [](double value) { return fmt::format("{:.2f} s", value); };
        entry.cells = {
            shown(v.judgement.interior_max, 2),
            fmt::format("{:.3f} %", v.judgement.tight_share * 100),
            std::to_string(v.judgement.explained + v.judgement.count(PixelClass::outlier)),
            v.picture.empty() ? std::to_string(v.judgement.count(PixelClass::known)) : "-",
            std::to_string(v.judgement.count(PixelClass::unexplained)),
            seconds(v.our_seconds),
            v.picture.empty() ? seconds(v.pov_seconds) : "-"};
        entry.urgency = static_cast<double>(v.judgement.count(PixelClass::unexplained)) +
                        v.judgement.interior_max;
    }
    if (v.cause) entry.notes.push_back({"Likely cause", *v.cause});
    add_notes(entry, v);
    add_files(entry, v);
    return entry;
}

std::vector<std::string> validation_columns(const std::string& other) {
    return {"Largest away from edges",
            "Within " + shown(Thresholds().tight),
            "Explained",
            "Known",
            "Unexplained",
            "Lancer",
            other};
}

Report validation_report(const reference::PovRay& povray, const std::string& lancer_version) {
    Report report;
    report.title = "Lancer against POV-Ray";
    report.left_name = "Lancer";
    report.right_name = "POV-Ray";
    const Thresholds defaults;
    report.columns = validation_columns("POV-Ray");
    report.histogram_marks = {defaults.tight, defaults.interior};
    report.about = {
        {"Programs",
         fmt::format("Lancer {}, in double precision; POV-Ray {}, an independent program that "
                     "reads each scene in its own language and renders it with its own primitives.",
                     lancer_version, povray.version)},
        {"Lancer's picture",
         "One ray through the centre of each pixel, all reflected and transmitted rays are "
         "followed. Linear light in 64-bit numbers, clipped to 0..1; never rounded before the "
         "comparison."},
        {"POV-Ray's picture",
         "One ray through the centre of each pixel (-A), adc_bailout 0, assumed_gamma 1.0, "
         "File_Gamma=1.0: a 16-bit PNG whose numbers are linear light, read as they are and "
         "divided by 65535. Half a step is 7.6e-6."},
        {"Judgement",
         fmt::format(
             "A pixel in which a channel differs by more than {} must be explained in one of three "
             "ways. An edge of geometry, shadow or texture passes within {:g} pixel of its centre, "
             "and beyond this edge our own picture has POV-Ray's value. Or POV-Ray follows another "
             "rule: then a second recursion must give POV-Ray's value by its rules, and ours "
             "without them. Or POV-Ray's own picture contradicts the value by what it shows on "
             "both sides of the pixel's centre. Explanations are limited: to at most {:g} % of the "
             "edge pixels, to at most {:g} % by edges that are off by more than {} pixel, to at "
             "most {:g} % of all pixels by contradictions, and there must be no shift between the "
             "pictures and no common direction of the offsets. Everything else is unexplained, and "
             "fails. Of the pixels away from edges {:g} % must agree within {}.",
             shown(defaults.interior), defaults.radius, defaults.explained_share * 100,
             defaults.displaced_share * 100, shown(defaults.rounding), defaults.outlier_share * 100,
             defaults.tight_share * 100, shown(defaults.tight))},
    };
    return report;
}

}  // namespace lancer::judge
