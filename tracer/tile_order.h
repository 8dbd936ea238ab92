// In which order a picture's tiles are dealt, so that the first of them tell of the whole.
#pragma once

#include <cstdint>
#include <numeric>

namespace lancer {

/// Visits 0 .. count-1 once each, by steps of count over the golden ratio: after any number of
/// steps the places visited are nearly even over the whole (Knuth, The Art of Computer Programming
/// 3, 6.4, theorem S). So the share of tiles that are done is about the share of the work.
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
