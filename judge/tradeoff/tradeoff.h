// Measures the cost and the error of each knob on one scene.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "judge/tradeoff/measured_error.h"
#include "judge/tradeoff/recommend.h"
#include "judge/tradeoff/settings.h"
#include "judge/tradeoff/steady_cost.h"
#include "judge/tradeoff/truth_cache.h"

namespace lancer::judge {

struct TradeOffOptions {
    double budget = 0;  ///< wall-clock seconds for everything; 0: no limit
    TruthCache cache;
    bool with_pictures = false;  ///< keep each setting's picture
    /// Called with the share that is done, and a description of the current step.
    std::function<void(double share, const std::string& what)> progress;
};

/// The measured results of one setting.
struct Measurement {
    TradeSetting setting;
    std::vector<double> seconds;  ///< of processor time, one per run
    double cost = 0;              ///< from steady_cost.h; 0: not known
    RayCounts rays;
    std::optional<std::uint64_t> memory_bytes;
    MeasuredError error;
    std::string error_png;    ///< if requested: the difference from the truth
    std::string guessed_png;  ///< if requested and predicted: the predicted difference
    std::string samples_png;  ///< if requested and not uniform: the samples of each pixel
    std::string png;          ///< its picture, if requested
    std::optional<std::size_t> beaten_by;  ///< index; nothing: on the frontier

    double median() const;
    /// The cost used for the frontier.
    double counted() const { return cost > 0 ? cost : median(); }
};

struct LeftOut {
    std::string setting;  ///< its label
    std::string why;
};

struct TradeOffReport {
    std::string scene;  ///< its name
    View view;
    int threads = 0;
    std::string level;  ///< of rays side by side
    std::vector<Measurement> settings;
    std::size_t exact = 0;  ///< index of the exact one
    std::vector<Advice> advice;
    std::vector<LeftOut> left_out;
    TraceLimits truth_limits;
    std::uint32_t truth_points = 0;  ///< per pixel, in both halves together
    double truth_error = 0;          ///< RMSE
    double truth_cut = 0;            ///< RMSE: a bound on what its limits cut
    bool truth_cached = false;       ///< at least in part
    std::string truth_png;           ///< if pictures were wanted
    double time_noise = 0;           ///< uncertainty of a median time, as a share of it
    RaySeconds ray_seconds;          ///< the fitted costs of rays
    double seconds = 0;              ///< wall-clock, of all

    int width() const { return view.crop ? view.crop->width : view.width; }
    int height() const { return view.crop ? view.crop->height : view.height; }
    double pixels() const { return static_cast<double>(width()) * height(); }
    /// The smallest error that is told.
    double least_error() const;
    /// Whether the bound on what the truth's limits cut is more than a tenth of that error.
    bool is_truth_cut_short() const { return 10 * truth_cut > least_error(); }
    bool is_truth_rough() const { return 3 * truth_error > least_error(); }
};

/// There is not even time for the truth and one setting; the message says how long they take.
struct BudgetTooShort : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Tries each knob alone and then promising combinations, against a truth that is refined until its
/// own error is a third of the smallest error expected. Times are medians over rounds through all
/// settings; the frontier uses a combination of times and rays. `scene.settings` gives threads (not
/// 0) and seed. Throws BudgetTooShort, SceneError.
TradeOffReport trade_off(const Scene& scene, const View& view, const TradeOffOptions& options);

}  // namespace lancer::judge
