// Names and string literals as small numbers, for fast comparison and lookup.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace lancer {

using Symbol = std::uint32_t;
inline constexpr Symbol no_symbol = 0xFFFFFFFF;

/// Stores every text once. A symbol and the address of its text are valid for the lifetime of the
/// table.
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
