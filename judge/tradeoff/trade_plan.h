// What measuring a scene's settings will take, how far it is, and what there is still time for.
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

/// A ray in every pixel is the unit.
class TradePlan {
  public:
    TradePlan(const Scene& scene, const View& view, const TurnedScene& turned,
              const TradeOffOptions& options)
        : scene_(scene), view_(view), turned_(turned), options_(options) {}

    /// Measures the unit, and decides how much of everything there is time for. Throws
    /// BudgetTooShort.
    void begin();

    double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
    bool fits(double seconds) const {
        return options_.budget == 0 || elapsed() + seconds <= options_.budget;
    }
    bool fits_units(double units) const { return fits(unit_ * units); }

    /// Progress through so many of all units that are planned.
    Progress stage(const std::string& what, double units);
    /// That a setting may take, guessed.
    double units_of(const TradeSetting& setting) const;
    /// Of runs of a setting and of the base by turns.
    int pairs_of(const TradeSetting& setting) const;

    /// Of the exact setting, each way.
    int samples() const { return samples_; }
    /// Of each half of the truth, at most and at first.
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

/// The share of the base's time that `turned` takes, by the quickest run of each: those of quiet
/// moments. A pair is a run of both. Now one and now the other goes first, so that neither is
/// always the one which finds the machine as the other has left it. Both return seconds.
///
/// \param goes_on  asked before each pair
double share_of_time(int pairs, const std::function<double()>& base,
                     const std::function<double()>& turned, const std::function<bool()>& goes_on);

/// Whether a knob may save time and no rays.
bool saves_time_alone(Knob knob);

}  // namespace lancer::judge
