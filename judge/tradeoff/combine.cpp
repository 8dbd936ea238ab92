#include "judge/tradeoff/combine.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "judge/tradeoff/frontier.h"

namespace lancer::judge {
namespace {

constexpr double least_gain = 0.97;           // a knob must reduce the rays to this share
constexpr double faster = 0.8;                // or the time to this one, which is then assumed
constexpr double worst_square = 0.05 * 0.05;  // the largest squared error of interest

struct Candidate {
    TradeSetting setting;
    TradePoint expected;  ///< cost in rays; error: squared
    int turned = 0;       ///< knobs beside the samples
};

/// The cost as a share of the base's. When a knob saves rays, their numbers give it without the
/// noise of the clock. When it saves only time, the clock decides whether it does, but not how
/// much: its noise would otherwise choose other combinations in each run. Few knobs save about a
/// fifth, so noise rarely decides.
double share_of_cost(const KnobEffect& e, const KnobEffect& base) {
    switch (e.setting.knob) {
        case Knob::max_depth:
        case Knob::min_contribution:
        case Knob::shadows:
            return e.rays / base.rays;
        default:
            return e.time < faster ? faster : 1;
    }
}

/// Selects up to `most` candidates, spread evenly over the logarithm of the error.
std::vector<Candidate> thinned(const std::vector<Candidate>& all, std::size_t most) {
    if (all.size() <= most) return all;
    const double first = std::log(all.front().expected.error);
    const double last = std::log(all.back().expected.error);
    std::vector<Candidate> kept;
    std::set<std::size_t> taken;
    for (std::size_t k = 0; k < most; ++k) {
        const double at =
            first + (last - first) * (static_cast<double>(k) + 0.5) / static_cast<double>(most);
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < all.size(); ++i)
            if (std::abs(std::log(all[i].expected.error) - at) <
                std::abs(std::log(all[nearest].expected.error) - at))
                nearest = i;
        if (taken.insert(nearest).second) kept.push_back(all[nearest]);
    }
    return kept;
}

}  // namespace

std::vector<TradeSetting> promising(const TurnedScene& turned, const KnobEffect& base,
                                    const std::vector<KnobEffect>& singles, std::size_t most) {
    std::vector<Candidate> all;
    for (const KnobEffect& e : singles) {
        if (e.setting.knob == Knob::samples || e.setting.knob == Knob::exact)
            all.push_back({e.setting, {e.rays, e.mean_square}, 0});
    }
    for (const Knob knob : {Knob::max_depth, Knob::min_contribution, Knob::tolerance,
                            Knob::precision, Knob::shadows, Knob::smooth, Knob::textures}) {
        const std::size_t before = all.size();
        for (const KnobEffect& e : singles) {
            if (e.setting.knob != knob) continue;
            const double share = share_of_cost(e, base);
            if (share > least_gain) continue;
            for (std::size_t i = 0; i < before; ++i) {
                Candidate c = all[i];
                take_knob(e.setting, c.setting.settings);
                c.expected.seconds *= share;
                c.expected.error += e.cut;
                ++c.turned;
                all.push_back(std::move(c));
            }
        }
        // A combination that is beaten now stays beaten: the other knobs change both in the same
        // way.
        std::vector<TradePoint> points;
        points.reserve(all.size());
        for (const Candidate& c : all) points.push_back(c.expected);
        std::vector<Candidate> kept;
        for (const std::size_t i : frontier(points)) kept.push_back(all[i]);
        all = std::move(kept);
    }
    std::set<std::string> known;
    for (const KnobEffect& e : singles) known.insert(e.setting.options);
    std::vector<Candidate> fresh;
    for (Candidate& c : all) {
        if (c.turned == 0 || !(c.expected.error > 0) || c.expected.error > worst_square) continue;
        c.setting.knob = Knob::combination;
        c.setting = named(turned, c.setting);
        if (known.insert(c.setting.options).second) fresh.push_back(c);
    }
    std::vector<TradeSetting> result;
    for (const Candidate& c : thinned(fresh, most)) result.push_back(c.setting);
    return result;
}

}  // namespace lancer::judge
