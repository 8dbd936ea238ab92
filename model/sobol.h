// Evenly distributed points of a square, for any number of points: Owen-scrambled Sobol points,
// scrambled by a hash. Sobol, "On the distribution of points in a cube", USSR Comput. Math. 7(4)
// 1967; Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995; the scrambling as a hash:
// Laine and Karras, "Stratified sampling for stochastic transparency", EGSR 2011, in the form of
// Burley, "Practical hash-based Owen scrambling", JCGT 9(4) 2020.
#pragma once

#include <cstdint>

namespace lancer {

/// A point of the unit square; each coordinate is in (0, 1).
struct SquarePoint {
    double x = 0;
    double y = 0;
};

/// One random sequence of points. Consider its first 2^m points, or 2^m later ones that begin at a
/// multiple of 2^m: each of the 2^m rectangles 2^-i x 2^(i-m) contains exactly one of them. Over
/// all keys each point is uniform in the square, so means over points are unbiased.
class SobolPoints {
  public:
    /// Sequences with different keys are independent.
    explicit SobolPoints(std::uint64_t key);

    /// The point with this index; it is the same on every machine.
    SquarePoint operator[](std::uint32_t index) const;

  private:
    std::uint32_t seed_x_;
    std::uint32_t seed_y_;
};

/// A key for SobolPoints; all its bits depend on each of these.
///
/// \param x, y    the pixel, in the whole picture
/// \param stream  distinguishes sequences in one pixel
std::uint64_t pixel_key(std::uint64_t seed, int x, int y, std::uint64_t stream = 0);

}  // namespace lancer
