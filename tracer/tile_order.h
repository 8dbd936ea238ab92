// The order of a picture's tiles, in which the first tiles are representative of all.
#pragma once

#include <cstdint>
#include <numeric>

namespace lancer {

/// Visits each of 0 .. count-1 once, by steps of count over the golden ratio. After any number of
/// steps, the visited numbers are spread nearly evenly (Knuth, The Art of Computer Programming
/// 3, 6.4, theorem S). So the share of finished tiles is about the share of finished work.
class TileOrder {
  public:
    explicit TileOrder(int count) : count_(count) {
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

}  // namespace lancer
