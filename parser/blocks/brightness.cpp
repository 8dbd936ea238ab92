#include "parser/blocks/brightness.h"

#include <array>
#include <cmath>

#include "parser/value.h"

namespace lancer {
namespace {

bool counts_to_255(const Color& color) {
    for (const double part : {color.x, color.y, color.z})
        if (part < 0 || part > 255 || part != std::floor(part)) return false;
    return true;
}

void warn(Report& report, const SourceSpan& place, const Color& color) {
    Diagnostic* warning = report.warning(
        Message::color_far_above_white, place,
        "[" + to_text(color.x) + ", " + to_text(color.y) + ", " + to_text(color.z) + "]");
    if (warning == nullptr) return;
    warning->hint =
        counts_to_255(color)
            ? fmt::format("1 is white; for values from 0 to 255 write #{:02x}{:02x}{:02x}",
                          static_cast<int>(color.x), static_cast<int>(color.y),
                          static_cast<int>(color.z))
            : "1 is white";
}

}  // namespace

void warn_bright_surface(Report& report, const SourceSpan& place, const Color& color) {
    if (max_component(color) > 2) warn(report, place, color);
}

void warn_bright_light(Report& report, const SourceSpan& place, const Color& color) {
    constexpr double least = 64;
    if (max_component(color) >= least && counts_to_255(color)) warn(report, place, color);
}

}  // namespace lancer
