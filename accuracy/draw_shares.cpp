#include "accuracy/draw_shares.h"

#include <algorithm>
#include <cmath>

#include "accuracy/prediction.h"

namespace lancer::accuracy {
namespace {

constexpr double least_share = 0.1;

double mix(const DrawShares& shares, const DrawShares& chances) {
    double sum = 0;
    for (std::size_t g = 0; g < guesses; ++g) sum += shares[g] * chances[g];
    return sum;
}

void normalize(DrawShares& shares) {
    double sum = 0;
    for (const double s : shares) sum += s;
    for (double& s : shares)
        s = least_share + (1 - static_cast<double>(guesses) * least_share) * s / sum;
}

}  // namespace

DrawGuesses::DrawGuesses(std::span<const double> predicted, int width, int height)
    : chances_(predicted.size()) {
    const double even = 1 / static_cast<double>(predicted.size());
    const auto add = [&](std::size_t guess, std::span<const double> values) {
        double total = 0;
        for (const double v : values) total += v;
        for (std::size_t i = 0; i < values.size(); ++i)
            chances_[i][guess] = total > 0 ? values[i] / total : even;
    };
    add(0, predicted);
    add(1, box_means(predicted, width, height, 3));
    add(2, box_means(predicted, width, height, 15));
    for (DrawShares& chances : chances_) chances[3] = even;
}

std::vector<double> DrawGuesses::mixed(const DrawShares& shares) const {
    std::vector<double> mixed(chances_.size());
    for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] = mix(shares, chances_[i]);
    return mixed;
}

DrawShares best_shares(std::span<const SeenDraw> draws) {
    // The mean of found^2 / (chance * mixture) estimates the second moment of a draw. It is convex
    // in the shares. Each step multiplies a share by the square root of the negative derivative.
    DrawShares free;
    free.fill(1.0 / static_cast<double>(guesses));
    DrawShares shares = free;
    for (int step = 0; step < 50; ++step) {
        DrawShares slope{};
        for (const SeenDraw& d : draws) {
            const double mixture = mix(shares, d.guessed);
            const double weight = d.found * d.found / (d.chance * mixture * mixture);
            for (std::size_t g = 0; g < guesses; ++g) slope[g] += weight * d.guessed[g];
        }
        double sum = 0;
        for (std::size_t g = 0; g < guesses; ++g) sum += free[g] *= std::sqrt(slope[g]);
        if (!(sum > 0 && std::isfinite(sum))) return first_shares;
        for (double& f : free) f /= sum;
        shares = free;
        normalize(shares);
    }
    return shares;
}

}  // namespace lancer::accuracy
