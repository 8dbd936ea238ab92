// Names and string literals as small numbers, so that they compare and look up at once.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace lancer {

using Symbol = std::uint32_t;
inline constexpr Symbol no_symbol = 0xFFFFFFFF;

/// Every text is stored once. A symbol stays valid, and its text in place, for the table's
/// lifetime.
class Symbols {
  public:
    Symbols();
    Symbol intern(std::string_view text);
    std::string_view text(Symbol symbol) const { return texts_[symbol]; }
    std::size_t size() const { return texts_.size(); }

  private:
    void grow();

    struct Slot {
        std::uint64_t hash = 0;
        Symbol symbol = no_symbol;
    };
    std::deque<std::string> texts_;
    std::vector<Slot> slots_;  ///< open addressing, a power of two, at most half full
};

}  // namespace lancer
