// What was found out about a scene's safe window: as a table, one sentence, JSON, and a plot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/stability/stability.h"

namespace lancer::judge {

/// A window that somebody asks for.
struct WindowDemand {
    std::string text;  ///< as it was asked for
    bool held = false;
};

struct StabilityReport {
    std::string scene;      ///< its name
    std::string precision;  ///< `double` and so on
    int width = 0;
    int height = 0;

    std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    StabilityOptions options;
    std::vector<Window> windows;
    std::optional<PovRayWindow> povray;  ///< nothing when nobody asked
    std::vector<WindowDemand> demands;
};

/// `1e-7`, `2^-40`, `1`: a power as people write it.
std::string power_text(Change change, int exponent);

// The table, line by line as it becomes known: per change where it is right, and what happens at
// the first step beyond.
std::string stability_head(const StabilityReport& report);
std::string stability_row(const StabilityReport& report, const Window& window);
std::string stability_row(const StabilityReport& report, const PovRayWindow& povray);
/// What was demanded, and the marks' meaning.
std::string stability_foot(const StabilityReport& report);

/// "right from 1e-7 to 1e11 times its size, …; POV-Ray from 1e-2 to 1e3", without a full stop.
std::string stability_sentence(const StabilityReport& report);

/// Everything, every sample too. Ends with a line feed. docs/stability.md has the keys.
/// Several reports: an object with the list of them as `scenes`.
std::string stability_json(const std::vector<StabilityReport>& reports);

/// Wrong pixels against the exponent, one panel per change that has one. An SVG document.
std::string stability_plot(const StabilityReport& report);

}  // namespace lancer::judge
