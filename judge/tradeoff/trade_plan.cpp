#include "judge/tradeoff/trade_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/tradeoff/run_setting.h"

namespace lancer::judge {
namespace {

constexpr double short_pairs = 0.5;  // seconds that additional pairs may take

}  // namespace

double TradePlan::pixels() const {
    return view_.crop ? static_cast<double>(view_.crop->width) * view_.crop->height
                      : static_cast<double>(view_.width) * view_.height;
}

Progress TradePlan::stage(const std::string& what, double units) {
    const double before = done_;
    done_ += units;
    if (!options_.progress) return {};
    return [this, what, units, before](double share) {
        options_.progress(std::min(0.99, (before + units * share) / planned_), what);
    };
}

double TradePlan::units_of(const TradeSetting& setting) const {
    if (!setting.max_error) return setting.points();
    // Roughly as in docs/cost-of-accuracy.md: smaller errors need more draws.
    const double finer = 0.01 / *setting.max_error;
    const double audits = setting.audited ? (100'000 + 40'000 * finer * finer) / pixels() : 0;
    return 4 + audits + 4 * std::pow(0.01 / *setting.max_error, 4.0 / 3);
}

int TradePlan::pairs_of(const TradeSetting& setting) const {
    const double seconds = 2 * unit_ * setting.points();
    return std::clamp(static_cast<int>(short_pairs / std::max(1e-6, seconds)), fewest_rounds,
                      most_rounds);
}

double TradePlan::planned_pairs() const {
    double units = 0;
    for (const TradeSetting& s : single_settings(turned_, samples_))
        if (saves_time_alone(s.knob)) units += 2 * s.points() * pairs_of(s);
    return units;
}

void TradePlan::begin() {
    unit_ = 1e300;
    // The first run may meet a busy moment, which matters in a small picture, so it is repeated.
    for (int look = 0; look < 3 && (look == 0 || unit_ < 0.05); ++look) {
        const TradeSetting one = exact_setting(turned_, 1);
        unit_ =
            std::min(unit_, run_setting(scene_, view_, one, stage("a first look", 1)).cost.wall);
    }
    double truth_units = 2 * 384.0;
    if (options_.budget > 0) {
        const double least = unit_ * (1 + 2 * first_truth_points + 4);
        if (!fits(least))
            throw BudgetTooShort(fmt::format("even the truth and one setting take about {:.2g} s",
                                             elapsed() + least));
        const double rays = options_.budget / unit_;
        for (const int n : {6, 4, 3, 2})
            if (samples_ * samples_ > 0.1 * rays) samples_ = n;
        truth_points_ = static_cast<std::uint32_t>(
            std::clamp<double>(0.4 * rays / 2, first_truth_points, truth_points_));
        truth_units = std::min(truth_units, 2.0 * truth_points_);
    }
    double once = 0;
    for (const TradeSetting& s : single_settings(turned_, samples_)) once += units_of(s);
    once += samples_ * samples_ + double(most_combinations) * 8;
    planned_ = 1 + truth_units + fewest_rounds * once + planned_pairs();
}

double share_of_time(int pairs, const std::function<double()>& base,
                     const std::function<double()>& turned, const std::function<bool()>& goes_on) {
    double of_base = 1e300;
    double of_turned = 1e300;
    for (int pair = 0; pair < pairs && goes_on(); ++pair) {
        if (pair % 2 == 0) of_base = std::min(of_base, base());
        of_turned = std::min(of_turned, turned());
        if (pair % 2 == 1) of_base = std::min(of_base, base());
    }
    return of_base == 1e300 ? 1 : of_turned / std::max(1e-6, of_base);
}

bool saves_time_alone(Knob knob) {
    return knob == Knob::tolerance || knob == Knob::precision || knob == Knob::smooth ||
           knob == Knob::textures;
}

}  // namespace lancer::judge
