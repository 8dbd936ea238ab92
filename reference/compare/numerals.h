// Numerals of 3 x 5 pixels, for the scale of a heat map.
#pragma once

#include <string_view>

#include "model/image.h"
#include "model/math.h"

namespace lancer::reference {

inline constexpr int numeral_height = 5;

/// The width in pixels of `text` when draw_numerals draws it.
int numerals_width(std::string_view text);

/// Draws `text`, which consists of 0-9 e . - and spaces, with its top left corner at (x, y). Parts
/// outside of the picture are cut off; other characters are left blank. `image` must have at least
/// 3 channels.
void draw_numerals(Image& image, int x, int y, std::string_view text, const Color& color);

}  // namespace lancer::reference
