#include "judge/tradeoff/tradeoff_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "judge/report/html.h"

namespace lancer::judge {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Measurement& m, const TradeOffReport& report) {
    const Settings& s = m.setting.settings;
    Json json{{"knob", name_of(m.setting.knob)},
              {"label", m.setting.label},
              {"options", m.setting.options},
              {"frontier", !m.beaten_by},
              {"beaten_by", m.beaten_by ? Json(*m.beaten_by) : Json()},
              {"cost", m.counted()},
              {"seconds", m.median()},
              {"runs", m.seconds},
              {"rays",
               {{"primary", m.rays.primary},
                {"shadow", m.rays.shadow},
                {"reflected", m.rays.reflected},
                {"transmitted", m.rays.transmitted}}},
              {"rays_per_pixel", static_cast<double>(m.rays.primary) / report.pixels()},
              {"memory_bytes", m.memory_bytes ? Json(*m.memory_bytes) : Json()},
              {"rmse", m.error.rmse},
              {"low", m.error.low},
              {"high", m.error.high},
              {"told", m.error.is_told()},
              {"p999", m.error.p999},
              {"flip", m.error.flip}};
    if (m.setting.max_error)
        json["max_error"] = *m.setting.max_error;
    else
        json["samples"] = s.samples;
    return json;
}

Json json_of(const Advice& a) {
    return {{"below", a.below},
            {"setting", a.use ? Json(*a.use) : Json()},
            {"times_as_fast", a.use ? Json(a.times_as_fast) : Json()}};
}

Json json_of(const TradeOffReport& r) {
    Json json{{"scene", r.scene},
              {"width", r.width()},
              {"height", r.height()},
              {"threads", r.threads},
              {"level", r.level},
              {"seconds", r.seconds},
              {"time_noise", r.time_noise},
              {"ray_seconds",
               {{"picture", r.ray_seconds.picture},
                {"depth", r.ray_seconds.depth},
                {"ray", r.ray_seconds.ray}}},
              {"truth",
               {{"rays_per_pixel", r.truth_points},
                {"rmse", r.truth_error},
                {"cut", std::isfinite(r.truth_cut) ? Json(r.truth_cut) : Json()},
                {"least_rmse", r.least_error()},
                {"max_depth", r.truth_limits.max_depth},
                {"min_contribution", r.truth_limits.min_contribution},
                {"cached", r.truth_cached}}},
              {"exact", r.exact},
              {"settings", Json::array()},
              {"advice", Json::array()},
              {"left_out", Json::array()}};
    for (const Measurement& m : r.settings) json["settings"].push_back(json_of(m, r));
    for (const Advice& a : r.advice) {
        json["advice"].push_back(json_of(a));
        json["advice"].back()["sentence"] = sentence(a, r.settings);
    }
    for (const LeftOut& l : r.left_out)
        json["left_out"].push_back({{"setting", l.setting}, {"why", l.why}});
    return json;
}

std::string seconds_text(double seconds) {
    return seconds < 10 ? fmt::format("{:.3f}", seconds) : fmt::format("{:.1f}", seconds);
}

std::string row(std::size_t number, const Measurement& m, const TradeOffReport& report) {
    const std::string memory =
        m.memory_bytes ? fmt::format("{:.1f}", static_cast<double>(*m.memory_bytes) / 1e6) : "-";
    return fmt::format(
        "{} {:>3} {:>8} {:>8} {:>8} {:>7} {:<29} {:>7} {:>7}  {}\n", m.beaten_by ? ' ' : '*',
        number, seconds_text(m.counted()), seconds_text(m.median()),
        shown(static_cast<double>(m.rays.primary) / report.pixels()), memory, error_text(m.error),
        shown(m.error.p999, 2), shown(m.error.flip, 2), m.setting.label);
}

}  // namespace

std::string error_text(const MeasuredError& e) {
    if (e.high == 0) return "none";
    if (!e.is_told()) return "below " + shown(e.high, 2);
    return fmt::format("{} ({} to {})", shown(e.rmse), shown(e.low), shown(e.high));
}

std::vector<std::size_t> by_cost(const TradeOffReport& report) {
    std::vector<std::size_t> order(report.settings.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return report.settings[a].counted() < report.settings[b].counted();
    });
    return order;
}

std::string tradeoff_text(const TradeOffReport& r) {
    std::string out = fmt::format("{} ({}x{}, {} thread{})\n", r.scene, r.width(), r.height(),
                                  r.threads, r.threads == 1 ? "" : "s");
    out += fmt::format("{:>5} {:>8} {:>8} {:>8} {:>7} {:<29} {:>7} {:>7}  {}\n", "no", "cost s",
                       "cpu s", "rays/px", "MB", "RMSE (95 %)", "99.9 %", "FLIP", "setting");
    for (const std::size_t i : by_cost(r)) out += row(i + 1, r.settings[i], r);
    out += "* no other setting is both cheaper and nearer to the truth\n" + cost_words(r) + "\n";
    out += fmt::format("truth: {} rays per pixel, its own error about {}{}\n", r.truth_points,
                       shown(r.truth_error, 2), r.truth_cached ? ", from the cache" : "");
    out += truth_cut_words(r) + "\n";
    if (r.is_truth_rough())
        out +=
            "this is more than a third of the smallest error, so that error has a wide interval\n";
    for (const Advice& a : r.advice) out += sentence(a, r.settings) + "\n";
    for (const LeftOut& l : r.left_out) out += fmt::format("left out: {}: {}\n", l.setting, l.why);
    return out;
}

std::string cost_words(const TradeOffReport& r) {
    return fmt::format(
        "cost: seconds of a setting's rays, from the price of each kind of ray in all settings "
        "together, corrected by the setting's own times where they clearly differ; times are known "
        "to about {:.0f} %",
        100 * r.time_noise);
}

std::string truth_cut_words(const TradeOffReport& r) {
    if (r.truth_cut == 0) return "its limits cut no light";
    if (!std::isfinite(r.truth_cut)) return "the light that its limits cut has no bound";
    return fmt::format("the light that its limits cut is an RMSE of at most {}{}",
                       shown(r.truth_cut, 2),
                       r.is_truth_cut_short() ? ", more than a tenth of the smallest error" : "");
}

std::string tradeoff_json(const std::vector<TradeOffReport>& reports) {
    Json json{{"scenes", Json::array()}};
    for (const TradeOffReport& r : reports) json["scenes"].push_back(json_of(r));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lancer::judge
