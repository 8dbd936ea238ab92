// Suggestions for misspelt words: "did you mean …?"
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lancer {

/// Collects candidates for a misspelt word and keeps the nearest.
class Suggestion {
  public:
    explicit Suggestion(std::string_view word);
    void consider(std::string_view candidate);
    /// "did you mean 'radius'?", or empty when nothing is near.
    std::string hint() const;
    bool empty() const { return best_.empty(); }
    const std::string& word() const { return best_; }

  private:
    std::string_view word_;
    std::uint32_t letters_;
    std::string best_;
    std::size_t least_;
};

/// The least number of insertions, deletions, substitutions and swaps of neighbours that turn one
/// word into the other; case is ignored; `limit` + 1 when there are more. Source: Damerau, "A
/// technique for computer detection and correction of spelling errors", CACM 7, 1964, in its
/// restricted form (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

}  // namespace lancer
