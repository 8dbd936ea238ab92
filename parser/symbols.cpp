#include "parser/symbols.h"

namespace lancer {
namespace {

/// FNV-1a with a final mix. With 64 bits, two different names hardly ever have equal hashes, so few
/// comparisons of texts fail.
std::uint64_t hash_of(std::string_view text) {
    std::uint64_t h = 0xcbf29ce484222325;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return h ^ (h >> 29);
}

}  // namespace

Symbol Symbols::find(std::string_view text, std::uint64_t hash) const {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = hash & mask; slots_[at].symbol != no_symbol; at = (at + 1) & mask)
        if (slots_[at].hash == hash && this->text(slots_[at].symbol) == text)
            return slots_[at].symbol;
    return no_symbol;
}

Symbol Symbols::intern(std::string_view text) {
    const std::uint64_t hash = hash_of(text);
    if (first_ != nullptr)
        if (const Symbol known = first_->find(text, hash); known != no_symbol) return known;
    if (const Symbol known = find(text, hash); known != no_symbol) return known;
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash & mask;
    while (slots_[at].symbol != no_symbol) at = (at + 1) & mask;
    const auto symbol = static_cast<Symbol>(size());
    texts_.emplace_back(text);
    slots_[at] = {hash, symbol};
    if (2 * texts_.size() > slots_.size()) grow();
    return symbol;
}

void Symbols::grow() {
    std::vector<Slot> bigger(2 * slots_.size());
    const std::size_t mask = bigger.size() - 1;
    for (const Slot& slot : slots_) {
        if (slot.symbol == no_symbol) continue;
        std::size_t at = slot.hash & mask;
        while (bigger[at].symbol != no_symbol) at = (at + 1) & mask;
        bigger[at] = slot;
    }
    slots_ = std::move(bigger);
}

}  // namespace lancer
