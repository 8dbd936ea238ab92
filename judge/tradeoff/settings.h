// The settings that `tradeoff` tries: ways to render one scene, as options of the command line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/requirements.h"
#include "model/scene.h"
#include "model/settings.h"
#include "tracer/render.h"

namespace lancer::judge {

/// The knob in which a setting differs from the uncut one.
enum class Knob : std::uint8_t {
    scene,  ///< as the script says
    exact,  ///< the most samples, nothing cut
    quality,
    samples,
    max_depth,
    min_contribution,
    tolerance,
    precision,
    shadows,
    smooth,
    textures,
    max_error,
    combination,  ///< of several
};
const char* name_of(Knob knob);

struct TradeSetting {
    Knob knob = Knob::samples;
    Settings settings;
    std::optional<double> max_error;  ///< if set, it determines samples and limits
    bool audited = true;              ///< with max_error
    std::string label;                ///< for a table: "sobol 4 x 4, depth 3"
    std::string options;              ///< of `lancer render`: "--sampling sobol --samples 4 ..."

    /// Rays per pixel that the settings ask for; 0 for a target error.
    double points() const {
        return max_error ? 0 : static_cast<double>(settings.samples) * settings.samples;
    }
};

/// The properties of a scene that decide which knobs matter.
struct TurnedScene {
    const Scene& scene;
    Requirements requirements;  ///< as if all that can be switched off were switched on
    double pixel = 1;           ///< the size of a pixel at the look_at point, in scene units
    Settings uncut;  ///< the script's settings with 1,000 levels in double; hardly anything is cut

    bool recurses() const;
    bool has_splines() const { return requirements.needs(Feature::splines); }
};
TurnedScene turned(const Scene& scene, const View& view);

/// The script's own settings.
TradeSetting own_setting(const TurnedScene& turned);
/// The settings of each quality word, except `exact` and those with more samples than
/// `most_samples` x `most_samples`.
std::vector<TradeSetting> quality_settings(const TurnedScene& turned, int most_samples);
/// `samples` x `samples` Sobol points without limits.
TradeSetting exact_setting(const TurnedScene& turned, int samples);
/// The base on which knobs other than the samples are tried: no limits, 3 x 3 Sobol points, or
/// `most_samples` when these are fewer.
TradeSetting base_setting(const TurnedScene& turned, int most_samples);
/// Each knob that matters for the scene, alone, from cheap to expensive; target errors come last.
/// The finest samples are a grid of `most_samples` x `most_samples`; below that Sobol points are
/// used.
std::vector<TradeSetting> single_settings(const TurnedScene& turned, int most_samples);

/// Sets label and options.
TradeSetting named(const TurnedScene& turned, TradeSetting setting);

/// The smallest target error.
inline constexpr double least_asked_error = 0.002;

/// Copies the value of the knob of `from` to `to`.
void take_knob(const TradeSetting& from, Settings& to);

}  // namespace lancer::judge
