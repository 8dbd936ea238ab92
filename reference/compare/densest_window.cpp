#include "reference/compare/densest_window.h"

#include <algorithm>
#include <cassert>

namespace lancer::reference {

double Window::share() const {
    const double area = static_cast<double>(width) * height;
    return area > 0 ? static_cast<double>(flagged) / area : 0;
}

Window densest_window(const std::vector<std::uint8_t>& flags, int width, int side) {
    assert(width > 0 && side > 0 && !flags.empty());
    const auto columns = static_cast<std::size_t>(width);
    const int height = static_cast<int>(flags.size() / columns);
    Window best{0, 0, std::min(side, width), std::min(side, height), 0};
    // sums[x]: the number of flags in column x, in the rows of the current window.
    std::vector<std::size_t> sums(columns, 0);
    for (int row = 0; row < height; ++row) {
        const auto flag = [&](int y, std::size_t x) -> std::size_t {
            return flags[static_cast<std::size_t>(y) * columns + x];
        };
        const int gone = row - best.height;
        for (std::size_t x = 0; x < columns; ++x)
            sums[x] += flag(row, x) - (gone >= 0 ? flag(gone, x) : 0);
        if (gone < -1) continue;
        std::size_t inside = 0;
        for (int x = 0; x < width; ++x) {
            inside += sums[static_cast<std::size_t>(x)];
            const int left = x - best.width + 1;
            if (left > 0) inside -= sums[static_cast<std::size_t>(left - 1)];
            if (left < 0 || inside <= best.flagged) continue;
            best.x = left;
            best.y = gone + 1;
            best.flagged = inside;
        }
    }
    return best;
}

}  // namespace lancer::reference
