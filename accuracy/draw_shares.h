// Which pixels an audit draws: a mixture of guesses where errors are, mixed as an earlier audit
// would have served best.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lancer::accuracy {

/// Guesses, each a share of the draws: the pixel's predicted error, its mean over 7 x 7 and over
/// 31 x 31 pixels, and none (all pixels alike).
inline constexpr std::size_t guesses = 4;
using DrawShares = std::array<double, guesses>;
inline constexpr DrawShares first_shares{0.5, 0.2, 0.1, 0.2};

/// The chances of all pixels by each guess; each guess sums to 1.
class DrawGuesses {
  public:
    DrawGuesses(std::span<const double> predicted, int width, int height);

    /// A pixel's chances, guess by guess.
    const DrawShares& of(std::size_t pixel) const { return chances_[pixel]; }
    /// Each pixel's chance in the mixture.
    std::vector<double> mixed(const DrawShares& shares) const;

  private:
    std::vector<DrawShares> chances_;
};

/// One draw of an audit: what the guesses gave its pixel, its chance in the mixture that was used,
/// and the squared error that was found there.
struct SeenDraw {
    DrawShares guessed;
    double chance;
    double found;
};

/// The shares with which the same draws would have had the least variance, none below a tenth.
DrawShares best_shares(std::span<const SeenDraw> draws);

}  // namespace lancer::accuracy
