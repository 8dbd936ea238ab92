// What `tradeoff` turns: ways to render one scene, as the command line says them.
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

/// What tells a setting from the uncut one.
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
    std::optional<double> max_error;  ///< then this chooses samples and limits
    bool audited = true;              ///< with max_error
    std::string label;                ///< for a table: "sobol 4 x 4, depth 3"
    std::string options;              ///< of `lancer render`: "--sampling sobol --samples 4 ..."

    /// Rays a pixel that the settings ask for; 0 where an error is asked for.
    double points() const {
        return max_error ? 0 : static_cast<double>(settings.samples) * settings.samples;
    }
};

/// What the scene gives to turn.
struct TurnedScene {
    const Scene& scene;
    Requirements requirements;  ///< with all that can be switched off switched on
    double pixel = 1;           ///< size of a pixel at what the camera looks at, scene units
    Settings uncut;  ///< the script's, but to 1,000 levels, in double; hardly anything cut

    bool recurses() const;
    bool has_splines() const { return requirements.needs(Feature::splines); }
};
TurnedScene turned(const Scene& scene, const View& view);

/// The script's own way.
TradeSetting own_setting(const TurnedScene& turned);
/// By one word; those with more samples than `most_samples` x `most_samples` are left out, and what
/// is exact.
std::vector<TradeSetting> quality_settings(const TurnedScene& turned, int most_samples);
/// `samples` x `samples` Sobol points and nothing cut.
TradeSetting exact_setting(const TurnedScene& turned, int samples);
/// Where knobs other than the samples are turned: uncut, with 3 x 3 Sobol points, or `most_samples`
/// where these are less.
TradeSetting base_setting(const TurnedScene& turned, int most_samples);
/// Each knob that the scene has a use for, alone, from cheap to dear, errors that are asked for
/// last. Samples end at a grid of `most_samples` x `most_samples` and below that on Sobol points.
std::vector<TradeSetting> single_settings(const TurnedScene& turned, int most_samples);

/// Fills in label and options.
TradeSetting named(const TurnedScene& turned, TradeSetting setting);

/// The finest of the errors that are asked for.
inline constexpr double least_asked_error = 0.002;

/// Gives `to` what `from` has by its knob.
void take_knob(const TradeSetting& from, Settings& to);

}  // namespace lancer::judge
