#include "judge/tradeoff/tradeoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "accuracy/cut_bound.h"
#include "accuracy/error_target.h"
#include "judge/report/report.h"
#include "judge/tradeoff/combine.h"
#include "judge/tradeoff/frontier.h"
#include "judge/tradeoff/run_setting.h"
#include "judge/tradeoff/setting_pictures.h"
#include "judge/tradeoff/trade_plan.h"

namespace lancer::judge {
namespace {

constexpr double wanted_ratio = 3;              // of the smallest error to that of the truth
constexpr double short_run = 0.2;               // seconds; slower settings run the fewest rounds
constexpr double short_rounds = 3;              // seconds that additional rounds may take
constexpr std::size_t picture_bytes = 100'000;  // of one on the page

/// The cost of a ray depends on it; see TimedSetting.
std::string way_of(const TradeSetting& setting) {
    const Settings& s = setting.settings;
    return fmt::format("{} {} {} {} {}", static_cast<int>(s.precision), s.tolerance.value_or(0),
                       s.smooth, s.textures, setting.max_error.has_value());
}

class TradeOff {
  public:
    TradeOff(const Scene& scene, const View& view, const TradeOffOptions& options)
        : scene_(scene),
          view_(view),
          options_(options),
          turned_(turned(scene, view)),
          limits_{turned_.uncut.max_depth, turned_.uncut.min_contribution},
          plan_(scene, view, turned_, options),
          truth_(view, limits_, scene.settings.seed) {
        report_.view = view;
        report_.threads = scene.settings.threads;
        report_.truth_limits = limits_;
    }

    TradeOffReport run() {
        plan_.begin();
        find_truth();
        measure_singles();
        measure_combinations();
        measure_errors();
        repeat();
        finish();
        return std::move(report_);
    }

  private:
    /// The error of a picture with a target is about a third below the target
    /// (docs/cost-of-accuracy.md).
    bool is_good_enough() const {
        const double own = truth_.error();
        const double least = std::min(report_.least_error(), 0.6 * least_asked_error);
        return own == 0 || (report_.settings[0].error.is_told() && wanted_ratio * own <= least);
    }

    /// Refines the truth until its own error is a third of those of the finest settings.
    void find_truth() {
        const std::string key =
            truth_key(options_.cache.content, view_, limits_, scene_.settings.seed);
        report_.truth_cached = read_truth(options_.cache, key, truth_);
        const std::uint32_t cached = truth_.points();
        Scene scene = scene_;
        scene.settings = turned_.uncut;
        const Scene surfaces = with_true_surfaces(std::move(scene));
        const std::unique_ptr<Renderer> renderer = compile(surfaces, surfaces.settings);
        report_.level = name_of(renderer->level());
        refine(*renderer, TradePlan::first_truth_points);
        // The finest settings, on Sobol points and on a grid.
        finest_.push_back(measure(exact_setting(turned_, plan_.samples())).value());
        for (const TradeSetting& s : single_settings(turned_, plan_.samples()))
            if (s.settings.sampling == Sampling::grid && s.settings.samples == plan_.samples() &&
                plan_.fits_units(s.points()))
                if (std::optional<Image> image = measure(s)) finest_.push_back(std::move(*image));
        while (!is_good_enough() && truth_.points() < plan_.truth_points()) {
            // Increases the points by factors of 1.5 and 1.33 in turn.
            const std::uint32_t now = truth_.points();
            const bool is_power = (now & (now - 1)) == 0;
            const std::uint32_t next =
                std::min(plan_.truth_points(), is_power ? now + now / 2 : now / 3 * 4);
            if (!plan_.fits_units(2.0 * (next - now))) break;
            refine(*renderer, next);
        }
        if (truth_.points() > cached) write_truth(options_.cache, key, truth_);
        report_.truth_cut =
            accuracy::bound_of_cut(*renderer, surfaces, view_, limits_,
                                   [&](int x, int y) { return truth_.first_points(x, y); }, {})
                .rmse;
    }

    void refine(const Renderer& renderer, std::uint32_t points) {
        if (points > truth_.points())
            truth_.refine(renderer, points,
                          plan_.stage("the truth", 2.0 * (points - truth_.points())));
        for (std::size_t i = 0; i < finest_.size(); ++i)
            report_.settings[i].error = error_of(finest_[i], truth_);
    }

    /// Nothing when the setting is left out.
    std::optional<Image> measure(const TradeSetting& setting) {
        if (!known_.insert(setting.options).second) return std::nullopt;
        const double units = plan_.units_of(setting);
        if (!report_.settings.empty() && !plan_.fits_units(units)) {
            leave_out(setting, "no time");
            return std::nullopt;
        }
        Measurement m;
        m.setting = setting;
        try {
            SettingRun run = run_setting(scene_, view_, setting, plan_.stage(setting.label, units));
            m.seconds.push_back(run.cost.processor);
            walls_.push_back(run.cost.wall);
            processor_.push_back(run.cost.processor);
            m.memory_bytes = run.cost.memory_bytes;
            m.rays = run.rays;
            m.error = error_of(run.image, truth_);
            if (options_.with_pictures) {
                SettingPictures pictures = pictures_of(run, truth_);
                m.png = std::move(pictures.picture);
                m.error_png = std::move(pictures.error);
                m.guessed_png = std::move(pictures.guessed);
                m.samples_png = std::move(pictures.samples);
            }
            report_.settings.push_back(std::move(m));
            return std::move(run.image);
        } catch (const accuracy::Unreachable& refused) {
            leave_out(setting, refused.what());
            return std::nullopt;
        }
    }

    void leave_out(const TradeSetting& setting, const std::string& why) {
        report_.left_out.push_back({setting.label, why});
    }

    static bool cuts(Knob knob) {
        return knob == Knob::max_depth || knob == Knob::min_contribution ||
               knob == Knob::tolerance || knob == Knob::precision || knob == Knob::shadows ||
               knob == Knob::smooth || knob == Knob::textures;
    }

    KnobEffect effect(std::size_t index, double cut) const {
        const Measurement& m = report_.settings[index];
        return {m.setting, static_cast<double>(m.rays.rays()), std::max(0.0, m.error.mean_square),
                cut, 1};
    }

    double share_of_base_time(const TradeSetting& setting) {
        const auto seconds_of = [&](const TradeSetting& s) {
            const std::string what = setting.label + ", beside the base";
            return run_setting(scene_, view_, s, plan_.stage(what, s.points())).cost.processor;
        };
        return share_of_time(
            plan_.pairs_of(setting), [&] { return seconds_of(base_.setting); },
            [&] { return seconds_of(setting); },
            // A factor of two, because what a knob leaves out may cost more than a ray.
            [&] { return plan_.fits_units(4 * setting.points()); });
    }

    /// Target errors come after combinations, which contribute more to the frontier.
    void measure_errors() {
        for (const TradeSetting& setting : single_settings(turned_, plan_.samples()))
            if (setting.max_error) measure(setting);
    }

    void measure_singles() {
        const TradeSetting base = base_setting(turned_, plan_.samples());
        const std::optional<Image> made = measure(base);
        const Image& base_image = made ? *made : finest_[0];
        base_ = effect(made ? report_.settings.size() - 1 : 0, 0);
        for (std::size_t i = 0; i < report_.settings.size(); ++i) singles_.push_back(effect(i, 0));
        measure(own_setting(turned_));
        for (const TradeSetting& setting : quality_settings(turned_, plan_.samples()))
            measure(setting);
        std::set<Knob> without_effect;  // finer settings have no effect either
        for (const TradeSetting& setting : single_settings(turned_, plan_.samples())) {
            if (setting.max_error || without_effect.contains(setting.knob)) continue;
            const std::optional<Image> image = measure(setting);
            if (!image) continue;
            const bool is_cut = cuts(setting.knob);
            const double cut = is_cut ? mean_square_between(*image, base_image) : 0;
            singles_.push_back(effect(report_.settings.size() - 1, cut));
            if (saves_time_alone(setting.knob)) singles_.back().time = share_of_base_time(setting);
            if (is_cut && cut == 0 && setting.knob != Knob::precision)
                without_effect.insert(setting.knob);
        }
        finest_.clear();
    }

    void measure_combinations() {
        for (const TradeSetting& setting : promising(turned_, base_, singles_, most_combinations))
            measure(setting);
    }

    /// Repeats all settings in rounds, so that a slow period affects all alike.
    void repeat() {
        double once = 0;
        double once_short = 0;
        double busy_short = 0;
        for (std::size_t i = 0; i < walls_.size(); ++i) {
            once += walls_[i];
            if (processor_[i] > short_run) continue;
            once_short += walls_[i];
            busy_short += processor_[i];
        }
        const int rounds = std::clamp(static_cast<int>(short_rounds / std::max(busy_short, 1e-3)),
                                      fewest_rounds, most_rounds);
        for (int round = 1; round < rounds; ++round) {
            const bool all = round < fewest_rounds;
            if (!plan_.fits(1.1 * (all ? once : once_short))) {
                if (round < fewest_rounds)
                    report_.left_out.push_back(
                        {"more rounds", fmt::format("no time left; the times are from {}", round)});
                return;
            }
            for (std::size_t i = 0; i < report_.settings.size(); ++i) {
                if (!all && processor_[i] > short_run) continue;
                Measurement& m = report_.settings[i];
                const SettingRun run =
                    run_setting(scene_, view_, m.setting,
                                plan_.stage(m.setting.label, plan_.units_of(m.setting)));
                m.seconds.push_back(run.cost.processor);
            }
        }
    }

    void finish() {
        std::vector<TimedSetting> timed;
        for (const Measurement& m : report_.settings)
            timed.push_back({way_of(m.setting), m.setting.settings.max_depth, m.rays, m.seconds});
        const SteadyCosts costs = steady_costs(timed);
        report_.time_noise = costs.noise;
        report_.ray_seconds = costs.fitted;
        std::vector<TradePoint> points;
        for (std::size_t i = 0; i < costs.seconds.size(); ++i) {
            report_.settings[i].cost = costs.seconds[i];
            points.push_back({costs.seconds[i], report_.settings[i].error.counted()});
        }
        const std::vector<std::optional<std::size_t>> beaten = dominators(points);
        for (std::size_t i = 0; i < points.size(); ++i) report_.settings[i].beaten_by = beaten[i];
        report_.advice = advice_from(report_.settings, report_.exact);
        report_.truth_points = 2 * truth_.points();
        report_.truth_error = truth_.error();
        if (options_.with_pictures)
            report_.truth_png = preview_of(truth_.image(), picture_bytes).png;
        report_.seconds = plan_.elapsed();
    }

    const Scene& scene_;
    const View& view_;
    const TradeOffOptions& options_;
    const TurnedScene turned_;
    const TraceLimits limits_;
    TradePlan plan_;
    TruePicture truth_;
    TradeOffReport report_;
    std::vector<Image> finest_;  ///< pictures of the first settings
    std::vector<double> walls_;
    std::vector<double> processor_;  ///< seconds of the first runs
    KnobEffect base_;
    std::vector<KnobEffect> singles_;
    std::set<std::string> known_;
};

}  // namespace

double Measurement::median() const {
    return median_of(seconds);
}

double TradeOffReport::least_error() const {
    double least = 1e300;
    for (const Measurement& m : settings)
        if (m.error.is_told()) least = std::min(least, m.error.rmse);
    return settings.empty() || least == 1e300 ? 0 : least;
}

TradeOffReport trade_off(const Scene& scene, const View& view, const TradeOffOptions& options) {
    return TradeOff(scene, view, options).run();
}

}  // namespace lancer::judge
