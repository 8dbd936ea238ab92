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
    Symbols() = default;
    /// Goes on where `first` ends, which grows no more and outlives this one: a small script costs
    /// no copy of the language's words.
    explicit Symbols(const Symbols* first)
        : first_(first), begin_(static_cast<Symbol>(first->size())) {}

    Symbol intern(std::string_view text);
    std::string_view text(Symbol symbol) const {
        return symbol < begin_ ? first_->text(symbol) : texts_[symbol - begin_];
    }
    std::size_t size() const { return begin_ + texts_.size(); }

  private:
    Symbol find(std::string_view text, std::uint64_t hash) const;
    void grow();

    struct Slot {
        std::uint64_t hash = 0;
        Symbol symbol = no_symbol;
    };
    const Symbols* first_ = nullptr;
    Symbol begin_ = 0;  ///< of its own texts
    std::deque<std::string> texts_;
    std::vector<Slot> slots_{64};  ///< open addressing, a power of two, at most half full
};

}  // namespace lancer
