// Numerals of 3 x 5 pixels, for the scale of a heat map.
#pragma once

#include <string_view>

#include "model/image.h"
#include "model/math.h"

namespace lancer::reference {

inline constexpr int numeral_height = 5;

/// Width in pixels of `text` as draw_numerals draws it.
int numerals_width(std::string_view text);

/// Draws `text`, of the characters 0-9 e . - and space, with its top left corner at (x, y). What
/// falls outside the picture is cut off; other characters are left blank. `image` has 3 channels or
/// more.
void draw_numerals(Image& image, int x, int y, std::string_view text, const Color& color);

}  // namespace lancer::reference
