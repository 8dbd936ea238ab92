// What a piece of work costs this process.
#pragma once

#include <cstdint>
#include <optional>

namespace lancer::judge {

struct Cost {
    double processor = 0;  ///< seconds of all threads together
    double wall = 0;       ///< seconds
    /// Beyond what was held before, at the most; nothing where the system does not tell.
    std::optional<std::uint64_t> memory_bytes;
};

/// Measures from its making on. One at a time.
class CostMeter {
  public:
    CostMeter();
    Cost cost() const;

  private:
    double processor_;
    double wall_;
    std::optional<std::uint64_t> held_;  ///< bytes
};

}  // namespace lancer::judge
