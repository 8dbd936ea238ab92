// Points of a square, spread evenly however many are taken: Owen-scrambled Sobol points by a hash.
// Sobol, "On the distribution of points in a cube", USSR Comput. Math. 7(4) 1967; Owen, "Randomly
// permuted (t,m,s)-nets and (t,s)-sequences", 1995; the scrambling as a hash: Laine and Karras,
// "Stratified sampling for stochastic transparency", EGSR 2011, in the form of Burley, "Practical
// hash-based Owen scrambling", JCGT 9(4) 2020.
#pragma once

#include <cstdint>

namespace lancer {

/// A place in the unit square; each coordinate lies in (0, 1).
struct SquarePoint {
    double x = 0;
    double y = 0;
};

/// One random sequence of points. Of its first 2^m points, and of every later run of 2^m that
/// begins at a multiple of 2^m, each of the 2^m rectangles 2^-i x 2^(i-m) holds exactly one. Over
/// all keys each point is uniform in the square, so means over points are unbiased.
class SobolPoints {
  public:
    /// Sequences of different keys are independent.
    explicit SobolPoints(std::uint64_t key);

    /// The point with this index: the same on every machine.
    SquarePoint operator[](std::uint32_t index) const;

  private:
    std::uint32_t seed_x_;
    std::uint32_t seed_y_;
};

/// A key for SobolPoints that depends on each of these in every bit.
///
/// \param x, y    the pixel, in the whole picture
/// \param stream  tells sequences in one pixel apart
std::uint64_t pixel_key(std::uint64_t seed, int x, int y, std::uint64_t stream = 0);

}  // namespace lancer
