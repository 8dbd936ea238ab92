#include "parser/suggest.h"

#include <algorithm>

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

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
    const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (difference > limit) return limit + 1;
    std::vector<std::size_t> older(b.size() + 1), old(b.size() + 1), row(b.size() + 1);
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
    : word_(word), least_(most_mistakes(word.size()) + 1) {}

void Suggestion::consider(std::string_view candidate) {
    if (word_.size() > longest_word || candidate == word_ || least_ == 0) return;
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
