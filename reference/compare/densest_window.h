// Finds where differences are concentrated: a share over the whole picture hides a small spot that
// is entirely wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lancer::reference {

/// A rectangle of pixels, and how many of them are flagged.
struct Window {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    std::size_t flagged = 0;

    double share() const;  ///< flagged per pixel of the window, 0..1; 0 for an empty window
};

/// The window of `side` x `side` pixels (smaller where the picture is smaller) with most flags; the
/// topmost and then leftmost among equals. `flags` are rows from the top, 0 or 1.
Window densest_window(const std::vector<std::uint8_t>& flags, int width, int side);

}  // namespace lancer::reference
