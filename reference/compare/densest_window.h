// Where differences crowd: a share over the whole picture hides a small spot that is all wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lancer::reference {

/// A rectangle of pixels, and how many in it are flagged.
struct Window {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    std::size_t flagged = 0;

    double share() const;  ///< flagged per pixel of the window, 0..1; 0 for an empty window
};

/// The window of `side` x `side` pixels (less where the picture is smaller) that holds most of the
/// flags; the topmost and then leftmost of equals. `flags` are rows from the top, 0 or 1.
Window densest_window(const std::vector<std::uint8_t>& flags, int width, int side);

}  // namespace lancer::reference
