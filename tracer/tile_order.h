// The order of a picture's tiles: the first ones represent the whole, and neighbours follow each
// other.
#pragma once

#include <cstdint>
#include <numeric>
#include <optional>

namespace lancer {

/// Visits each of 0 .. count-1 once, by steps of count over the golden ratio. After any number of
/// steps, the visited numbers are spread nearly evenly (Knuth, The Art of Computer Programming
/// 3, 6.4, theorem S).
class SpreadOrder {
  public:
    explicit SpreadOrder(int count) : count_(count) {
        step_ = static_cast<int>(count * 0.6180339887498949);
        while (step_ > 1 && std::gcd(step_, count) != 1) --step_;
        if (step_ < 1) step_ = 1;
    }
    int operator[](int index) const {
        return static_cast<int>(std::int64_t(index) * step_ % count_);
    }

  private:
    int count_;
    int step_;
};

struct TilePlace {
    int column, row;
};

/// Square blocks of tiles in the order above, so that the share of finished tiles is about the
/// share of finished work; and the tiles of a block one after the other, because their rays meet
/// the same parts of the scene, which are then in the caches.
class TileOrder {
  public:
    TileOrder(int across, int down) : TileOrder(across, down, side_for(across, down)) {}

    /// The number of indices. Some lie in blocks that the picture's edge cuts, outside of it.
    int count() const { return side_ * side_ * blocks_across_ * blocks_down_; }

    /// \return nothing if no tile has this index
    std::optional<TilePlace> operator[](int index) const {
        const int block = order_[index / (side_ * side_)];
        TilePlace place{block % blocks_across_ * side_, block / blocks_across_ * side_};
        // Z-order: the bits of the index belong to the column and to the row in turn.
        for (int bit = 1, rest = index % (side_ * side_); bit < side_; bit *= 2, rest /= 4) {
            place.column += rest % 2 * bit;
            place.row += rest / 2 % 2 * bit;
        }
        if (place.column >= across_ || place.row >= down_) return std::nullopt;
        return place;
    }

  private:
    /// Fewer blocks would not represent the picture.
    static constexpr int fewest_blocks = 256;
    static constexpr int longest_side = 8;

    TileOrder(int across, int down, int side)
        : across_(across),
          down_(down),
          side_(side),
          blocks_across_((across + side - 1) / side),
          blocks_down_((down + side - 1) / side),
          order_(blocks_across_ * blocks_down_) {}

    static int side_for(int across, int down) {
        int side = 1;
        while (2 * side <= longest_side &&
               std::int64_t(across / (2 * side)) * (down / (2 * side)) >= fewest_blocks)
            side *= 2;
        return side;
    }

    int across_, down_;
    int side_;  ///< of a block, in tiles; a power of two
    int blocks_across_, blocks_down_;
    SpreadOrder order_;
};

}  // namespace lancer
