#include "judge/validate/validation_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>

#include "judge/report/entry_html.h"

namespace lancer::judge {

std::string table_head(std::size_t name_width, const std::string& other) {
    return fmt::format("{:<{}}  {:<8} {:>9} {:>9} {:>9} {:>11} {:>6} {:>10} {:>7} {:>9}\n", "scene",
                       name_width, "verdict", "interior", "within", "explained", "unexplained",
                       "known", "coincident", "ours", other);
}

std::string table_row(const Validation& v, std::size_t name_width) {
    std::string row = fmt::format("{:<{}}  {:<8}", v.name, name_width, verdict_name(v.verdict));
    if (v.comparison.comparable) {
        const Judgement& j = v.judgement;
        const auto by_povray = [&](PixelClass c) {
            return v.picture.empty() ? std::to_string(j.count(c)) : "-";
        };
        row += fmt::format(" {:>9.2g} {:>7.3f} % {:>9} {:>11} {:>6} {:>10}", j.interior_max,
                           j.tight_share * 100, j.explained + j.count(PixelClass::outlier),
                           j.count(PixelClass::unexplained), by_povray(PixelClass::known),
                           by_povray(PixelClass::coincident));
        row += fmt::format(" {:>5.2f} s", v.our_seconds);
        row += v.picture.empty()
                   ? fmt::format(" {:>7.2f} s{}", v.pov_seconds, v.from_cache ? " (kept)" : "")
                   : fmt::format(" {:>9}", "-");
    }
    row += '\n';
    if (v.cause) row += "    likely cause: " + *v.cause + "\n";
    for (const std::string& reason : v.reasons) row += "    " + reason + "\n";
    return row;
}

namespace {

nlohmann::ordered_json shift_json(const Shift& shift) {
    return {{"x", shift.x},
            {"y", shift.y},
            {"error_x", shift.error_x},
            {"error_y", shift.error_y},
            {"count", shift.count}};
}

/// The worst pixels: unexplained ones first, then by decreasing difference; at most 20.
nlohmann::ordered_json worst_json(const Judgement& judgement, const std::string& other) {
    std::vector<DifferentPixel> worst = judgement.different;
    std::stable_sort(worst.begin(), worst.end(), [](const auto& a, const auto& b) {
        const bool unexplained = a.pixel_class == PixelClass::unexplained;
        if (unexplained != (b.pixel_class == PixelClass::unexplained)) return unexplained;
        return a.difference > b.difference;
    });
    worst.resize(std::min<std::size_t>(20, worst.size()));
    auto list = nlohmann::ordered_json::array();
    for (const DifferentPixel& p : worst)
        list.push_back({{"x", p.x},
                        {"y", p.y},
                        {"class", class_name(p.pixel_class)},
                        {"difference", p.difference},
                        {"lancer", {p.ours.x, p.ours.y, p.ours.z}},
                        {other, {p.theirs.x, p.theirs.y, p.theirs.z}}});
    return list;
}

/// Classes that need POV-Ray, which a picture cannot replace.
std::vector<std::string> names_of_undecidable() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < pixel_classes; ++i) {
        const auto c = static_cast<PixelClass>(i);
        if (needs_povray(c)) names.push_back(class_name(c));
    }
    return names;
}

nlohmann::ordered_json scene_json(const Validation& v) {
    nlohmann::ordered_json json;
    json["name"] = v.name;
    json["path"] = v.path;
    json["verdict"] = verdict_name(v.verdict);
    json["reasons"] = v.reasons;
    if (!v.picture.empty()) {
        json["picture"] = v.picture;
        json["cause"] =
            v.cause ? nlohmann::ordered_json(*v.cause) : nlohmann::ordered_json(nullptr);
    }
    if (!v.comparison.comparable) return json;
    const Judgement& j = v.judgement;
    json["pixels"] = j.pixels;
    json["edge_pixels"] = j.edge_pixels;
    json["interior_max"] = j.interior_max;
    json["interior_p999"] = j.interior_p999;
    json["tight_share"] = j.tight_share;
    json["unexplained"] = j.count(PixelClass::unexplained);
    json["explained"] = {{"total", j.explained},
                         {"silhouette", j.count(PixelClass::silhouette)},
                         {"shadow", j.count(PixelClass::shadow)},
                         {"texture", j.count(PixelClass::texture)},
                         {"reflected_edge", j.count(PixelClass::secondary)},
                         {"steep", j.count(PixelClass::steep)},
                         {"displaced", j.displaced}};
    if (v.picture.empty()) {
        json["outliers"] = j.count(PixelClass::outlier);
        json["known"] = j.count(PixelClass::known);
        json["coincident"] = j.count(PixelClass::coincident);
    } else {
        json["not_decidable_from_a_picture"] = names_of_undecidable();
    }
    json["coincidences"] = nlohmann::ordered_json::array();
    for (const reference::Coincidence& c : v.coincidences)
        json["coincidences"].push_back({{"first", c.first},
                                        {"second", c.second},
                                        {"resolution", reference::resolution_name(c.resolution)}});
    json["not_looked_at"] = j.not_looked_at;
    json["explaining_rays"] = j.rays;
    json["edge_shift"] = shift_json(j.edge_shift);
    json["picture_shift"] = shift_json(j.picture_shift);
    json["worst"] = worst_json(j, v.picture.empty() ? "povray" : "picture");
    json["mean"] = v.comparison.mean;
    json["rmse"] = v.comparison.rmse;
    json["max"] = v.comparison.max;
    json["max_at"] = {v.comparison.max_x, v.comparison.max_y};
    json["p99"] = v.comparison.p99;
    json["p999"] = v.comparison.p999;
    json["flip"] = v.comparison.flip;
    json["exposure"] = v.exposure;
    json["factor"] = v.factor;
    json["seconds"] = {{"lancer", v.our_seconds}, {"povray", v.pov_seconds}};
    json["from_cache"] = v.from_cache;
    return json;
}

}  // namespace

std::string validations_to_json(const std::vector<Validation>& validations,
                                const std::string& povray_version) {
    nlohmann::ordered_json json;
    bool pass = true;
    for (const Validation& v : validations) {
        pass = pass && (v.verdict == Verdict::agrees || v.verdict == Verdict::refused);
    }
    json["verdict"] = pass ? "pass" : "fail";
    if (!povray_version.empty()) json["povray"] = povray_version;
    json["scenes"] = nlohmann::ordered_json::array();
    for (const Validation& v : validations) json["scenes"].push_back(scene_json(v));
    // Messages of other programs may contain any bytes.
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::vector<JUnitCase> junit_cases(const std::vector<Validation>& validations) {
    std::vector<JUnitCase> cases;
    for (const Validation& v : validations) {
        JUnitCase made{v.path, v.our_seconds + v.pov_seconds, {}, v.reasons};
        if (v.cause) made.reasons.insert(made.reasons.begin(), "likely cause: " + *v.cause);
        switch (v.verdict) {
            case Verdict::agrees:
                break;
            case Verdict::differs:
                made.outcome = JUnitCase::Outcome::failed;
                break;
            case Verdict::refused:
                made.outcome = JUnitCase::Outcome::skipped;
                break;
            case Verdict::failed:
                made.outcome = JUnitCase::Outcome::error;
                break;
        }
        cases.push_back(std::move(made));
    }
    return cases;
}

}  // namespace lancer::judge
