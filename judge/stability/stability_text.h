// A scene's safe window as a table, one sentence, JSON, and a plot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/stability/stability.h"

namespace lancer::judge {

/// A window that the user requires.
struct WindowDemand {
    std::string text;  ///< as the user wrote it
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
    std::optional<PovRayWindow> povray;  ///< nothing when not requested
    std::vector<WindowDemand> demands;
};

/// `1e-7`, `2^-40`, `1`: a power as people write it.
std::string power_text(Change change, int exponent);

// The table, line by line as results arrive: for each change, where the picture is right, and what
// happens at the first step beyond.
std::string stability_head(const StabilityReport& report);
std::string stability_row(const StabilityReport& report, const Window& window);
std::string stability_row(const StabilityReport& report, const PovRayWindow& povray);
/// The result of each requirement, and the meaning of the marks.
std::string stability_foot(const StabilityReport& report);

/// "right from 1e-7 to 1e11 times its size, …; POV-Ray from 1e-2 to 1e3", without a full stop.
std::string stability_sentence(const StabilityReport& report);

/// Everything, including every sample; docs/stability.md describes the keys. Ends with a line feed.
/// Several reports become an object with a list, `scenes`.
std::string stability_json(const std::vector<StabilityReport>& reports);

/// Wrong pixels against the exponent, one panel for each change that has exponents. An SVG
/// document.
std::string stability_plot(const StabilityReport& report);

}  // namespace lancer::judge
