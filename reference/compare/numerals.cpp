#include "reference/compare/numerals.h"

#include <array>

namespace lancer::reference {

namespace {

constexpr int glyph_width = 3;
constexpr int advance = glyph_width + 1;

struct Glyph {
    char character;
    std::array<std::string_view, numeral_height> rows;
};

constexpr std::array<Glyph, 13> glyphs = {{
    {'0', {"###", "# #", "# #", "# #", "###"}},
    {'1', {" # ", "## ", " # ", " # ", "###"}},
    {'2', {"###", "  #", "###", "#  ", "###"}},
    {'3', {"###", "  #", "###", "  #", "###"}},
    {'4', {"# #", "# #", "###", "  #", "  #"}},
    {'5', {"###", "#  ", "###", "  #", "###"}},
    {'6', {"###", "#  ", "###", "# #", "###"}},
    {'7', {"###", "  #", "  #", " # ", " # "}},
    {'8', {"###", "# #", "###", "# #", "###"}},
    {'9', {"###", "# #", "###", "  #", "###"}},
    {'e', {"   ", "###", "# #", "#  ", " ##"}},
    {'.', {"   ", "   ", "   ", "   ", " # "}},
    {'-', {"   ", "   ", "###", "   ", "   "}},
}};

void set_pixel(Image& image, int x, int y, const Color& color) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
    double* pixel = image.pixel(x, y);
    pixel[0] = color.x;
    pixel[1] = color.y;
    pixel[2] = color.z;
}

}  // namespace

int numerals_width(std::string_view text) {
    return text.empty() ? 0 : static_cast<int>(text.size()) * advance - 1;
}

void draw_numerals(Image& image, int x, int y, std::string_view text, const Color& color) {
    for (const char character : text) {
        for (const Glyph& glyph : glyphs) {
            if (glyph.character != character) continue;
            for (int row = 0; row < numeral_height; ++row) {
                for (int column = 0; column < glyph_width; ++column) {
                    const bool ink = glyph.rows[static_cast<std::size_t>(row)]
                                               [static_cast<std::size_t>(column)] == '#';
                    if (ink) set_pixel(image, x + column, y + row, color);
                }
            }
        }
        x += advance;
    }
}

}  // namespace lancer::reference
