// The probabilities by which an audit draws pixels: a mixture of several guesses of where errors
// are. The shares of the mixture follow from an earlier audit.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lancer::accuracy {

/// The guesses: the pixel's predicted error, its mean over 7 x 7 and over 31 x 31 pixels, and a
/// uniform distribution. DrawShares has each guess's share of the draws.
inline constexpr std::size_t guesses = 4;
using DrawShares = std::array<double, guesses>;
inline constexpr DrawShares first_shares{0.5, 0.2, 0.1, 0.2};

/// The probabilities of all pixels by each guess. Those of one guess sum to 1.
class DrawGuesses {
  public:
    DrawGuesses(std::span<const double> predicted, int width, int height);

    /// A pixel's probabilities, one per guess.
    const DrawShares& of(std::size_t pixel) const { return chances_[pixel]; }
    /// Each pixel's probability in the mixture.
    std::vector<double> mixed(const DrawShares& shares) const;

  private:
    std::vector<DrawShares> chances_;
};

/// One draw of an audit: the pixel's probabilities by the guesses, its probability in the mixture
/// that was used, and the squared error that was found there.
struct SeenDraw {
    DrawShares guessed;
    double chance;
    double found;
};

/// The shares, each at least a tenth, for which the draws' estimated variance is least.
DrawShares best_shares(std::span<const SeenDraw> draws);

}  // namespace lancer::accuracy
