#include "parser/suggest.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace lancer {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// A third of the letters may be wrong. A single letter may differ only in case.
std::size_t most_mistakes(std::size_t length) {
    return (length + 1) / 3;
}

constexpr std::size_t longest_word = 64;

/// Which letters a word has; some share a bit.
std::uint32_t letters_of(std::string_view word) {
    std::uint32_t letters = 0;
    for (const char c : word) letters |= 1U << (static_cast<unsigned char>(lower(c)) & 31U);
    return letters;
}

/// No mistake brings or takes more than one letter, so that the distance is at least this.
std::size_t least_distance(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::size_t>(std::max(std::popcount(a & ~b), std::popcount(b & ~a)));
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
    const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (difference > limit) return limit + 1;
    // Three rows of the table, on the stack for words as people write them.
    constexpr std::size_t on_stack = longest_word + longest_word / 2;
    std::array<std::size_t, 3 * on_stack> place;
    std::vector<std::size_t> larger_place;
    if (b.size() >= on_stack) larger_place.resize(3 * (b.size() + 1));
    std::size_t* older = larger_place.empty() ? place.data() : larger_place.data();
    std::size_t* old = older + b.size() + 1;
    std::size_t* row = old + b.size() + 1;
    for (std::size_t j = 0; j <= b.size(); ++j) old[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({old[j] + 1, row[j - 1] + 1, old[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1]))
                row[j] = std::min(row[j], older[j - 2] + 1);
        }
        std::swap(older, old);
        std::swap(old, row);
    }
    return std::min(old[b.size()], limit + 1);
}

Suggestion::Suggestion(std::string_view word)
    : word_(word), letters_(letters_of(word)), least_(most_mistakes(word.size()) + 1) {}

void Suggestion::consider(std::string_view candidate) {
    if (word_.size() > longest_word || candidate == word_ || least_ == 0) return;
    if (least_distance(letters_, letters_of(candidate)) >= least_) return;
    const std::size_t distance = edit_distance(word_, candidate, least_ - 1);
    // At least one letter of the candidate must be meant: "x" is not near "pi".
    if (distance < least_ && distance < candidate.size()) {
        least_ = distance;
        best_ = candidate;
    }
}

std::string Suggestion::hint() const {
    return best_.empty() ? "" : "did you mean '" + best_ + "'?";
}

}  // namespace lancer
