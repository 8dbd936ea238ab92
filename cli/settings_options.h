// The options that override a script's `render { … }`.
#pragma once

#include <cstdint>
#include <optional>

#include "model/quality.h"
#include "model/settings.h"

namespace CLI {
class App;
}

namespace lancer::cli {

struct SettingsOptions {
    std::optional<std::int64_t> threads;
    std::optional<Quality> quality;  ///< the members below override its values
    std::optional<std::int64_t> max_depth;
    std::optional<double> min_contribution;
    std::optional<std::int64_t> samples;
    std::optional<Sampling> sampling;
    std::optional<std::int64_t> seed;
    std::optional<double> tolerance;
    std::optional<Precision> precision;
    bool no_shadows = false;
    bool no_smooth = false;
    bool no_textures = false;

    /// Threads that read a scene; 0: as many as the machine has.
    int reading_threads() const { return static_cast<int>(threads.value_or(0)); }
    /// Options of the command line replace `settings`. In the result `threads` is never 0.
    void apply_to(Settings& settings) const;
};

void add_settings_options(CLI::App& app, SettingsOptions& options);

}  // namespace lancer::cli
