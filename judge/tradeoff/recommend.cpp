#include "judge/tradeoff/recommend.h"

#include <fmt/format.h>

#include "judge/report/html.h"
#include "judge/tradeoff/tradeoff.h"

namespace lancer::judge {

std::vector<Advice> advice_from(const std::vector<Measurement>& settings, std::size_t exact) {
    std::vector<Advice> all;
    for (const auto& [below, text] :
         {std::pair{0.02, "0.02"}, {1.0 / 255, "1/255"}, {0.001, "1/1000"}}) {
        Advice advice{below, text, {}, 1};
        for (std::size_t i = 0; i < settings.size(); ++i) {
            if (settings[i].beaten_by || !(settings[i].error.high <= below)) continue;
            if (!advice.use || settings[i].counted() < settings[*advice.use].counted())
                advice.use = i;
        }
        if (advice.use) {
            const double cost = settings[*advice.use].counted();
            if (cost > 0) advice.times_as_fast = settings[exact].counted() / cost;
        }
        all.push_back(advice);
    }
    return all;
}

std::string sentence(const Advice& advice, const std::vector<Measurement>& settings) {
    const std::string start = fmt::format("for an error below {}: ", advice.below_text);
    if (!advice.use) {
        double best = 1e300;
        for (const Measurement& m : settings) best = std::min(best, m.error.high);
        return start + fmt::format("none of these settings; the best reaches {}", shown(best));
    }
    const Measurement& m = settings[*advice.use];
    const std::string name =
        m.setting.options.empty() ? "the scene's own settings" : m.setting.options;
    const std::string speed = advice.times_as_fast < 1.05 && advice.times_as_fast > 0.95
                                  ? "as fast as exact"
                                  : shown(advice.times_as_fast, 2) + " times as fast as exact";
    return start + fmt::format("{}, {} (RMSE {})", name, speed, shown(m.error.counted(), 2));
}

}  // namespace lancer::judge
