// Plans the measurements of a scene's settings: their cost, the progress, and what there is still
// time for.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "judge/tradeoff/settings.h"
#include "judge/tradeoff/tradeoff.h"

namespace lancer::judge {

inline constexpr int fewest_rounds = 3;
inline constexpr int most_rounds = 15;
inline constexpr std::size_t most_combinations = 16;

/// The unit of cost is one ray in every pixel.
class TradePlan {
  public:
    TradePlan(const Scene& scene, const View& view, const TurnedScene& turned,
              const TradeOffOptions& options)
        : scene_(scene), view_(view), turned_(turned), options_(options) {}

    /// Measures the unit, and divides the time among the steps. Throws BudgetTooShort.
    void begin();

    double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
    bool fits(double seconds) const {
        return options_.budget == 0 || elapsed() + seconds <= options_.budget;
    }
    bool fits_units(double units) const { return fits(unit_ * units); }

    /// Progress through this many of all planned units.
    Progress stage(const std::string& what, double units);
    /// The predicted cost of a setting in units.
    double units_of(const TradeSetting& setting) const;
    /// The number of pairs of runs of a setting and of the base.
    int pairs_of(const TradeSetting& setting) const;

    /// Samples of the exact setting, on each axis.
    int samples() const { return samples_; }
    /// Points of each half of the truth: the maximum, and the number at first.
    std::uint32_t truth_points() const { return truth_points_; }
    static constexpr std::uint32_t first_truth_points = 16;

  private:
    using Clock = std::chrono::steady_clock;
    double pixels() const;
    double planned_pairs() const;

    const Scene& scene_;
    const View& view_;
    const TurnedScene& turned_;
    const TradeOffOptions& options_;
    Clock::time_point begin_ = Clock::now();
    double unit_ = 0;  ///< seconds
    int samples_ = 8;
    std::uint32_t truth_points_ = 4096;
    double planned_ = 1;
    double done_ = 0;
};

/// The share of the base's time that `turned` takes, from the fastest run of each, which met no
/// other work. A pair is a run of both. Their order alternates, so that neither always finds the
/// machine as the other left it. Both functions return seconds.
///
/// \param goes_on  called before each pair
double share_of_time(int pairs, const std::function<double()>& base,
                     const std::function<double()>& turned, const std::function<bool()>& goes_on);

/// Whether a knob may save time without saving rays.
bool saves_time_alone(Knob knob);

}  // namespace lancer::judge
