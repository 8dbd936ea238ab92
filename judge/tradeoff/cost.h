// Measures the cost of a piece of work in this process.
#pragma once

#include <cstdint>
#include <optional>

namespace lancer::judge {

struct Cost {
    double processor = 0;  ///< seconds of all threads together
    double wall = 0;       ///< seconds
    /// The peak memory beyond what was held before; nothing when the system does not report it.
    std::optional<std::uint64_t> memory_bytes;
};

/// Measures from its construction on. Only one may exist at a time.
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
