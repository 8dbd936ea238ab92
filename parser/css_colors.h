// The named colours of the web. Source: CSS Color Module Level 4, section 6.1.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace lancer {

struct CssColor {
    std::string_view name;
    std::uint32_t srgb;  ///< 0xrrggbb
};

std::span<const CssColor> css_colors();
/// The colour with this name, in lower case; nullptr when there is none.
const CssColor* css_color(std::string_view name);

}  // namespace lancer
