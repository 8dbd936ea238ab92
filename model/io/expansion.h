// Exact sums: the sign of an expression in doubles, unaffected by rounding.
//
// J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates, Discrete & Computational Geometry 18 (1997), sections 2 and 4. Exact as long as no
// product underflows; callers scale their input to about 1.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "model/math.h"

namespace lancer::io {

/// A number as the sum of up to `Capacity` doubles that do not overlap, the smallest first.
template <std::size_t Capacity>
class Expansion {
  public:
    /// Adds `value` exactly (Grow-Expansion, figure 6).
    void add(double value) {
        for (std::size_t i = 0; i < size_; ++i) {
            const double sum = value + terms_[i];
            const double part = sum - value;
            terms_[i] = (value - (sum - part)) + (terms_[i] - part);
            value = sum;
        }
        terms_[size_++] = value;
    }

    /// Adds a * b exactly.
    void add_product(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }

    /// -1, 0 or 1.
    int sign() const {
        for (std::size_t i = size_; i-- > 0;) {
            if (terms_[i] != 0) return terms_[i] > 0 ? 1 : -1;
        }
        return 0;
    }

  private:
    std::array<double, Capacity> terms_{};
    std::size_t size_ = 0;
};

/// 1 when a, b, c turn left, -1 when they turn right, 0 when they are collinear. Exact.
inline int orientation(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    // The filter of section 4.3, figure 21: (3 + 16 u) u with u = 2^-53, rounded up.
    if (std::abs(determinant) > 3.3306690738754716e-16 * (std::abs(left) + std::abs(right))) {
        return determinant > 0 ? 1 : -1;
    }
    Expansion<12> sum;  // the determinant expanded; c.x c.y cancels
    sum.add_product(a.x, b.y);
    sum.add_product(-a.x, c.y);
    sum.add_product(-c.x, b.y);
    sum.add_product(-a.y, b.x);
    sum.add_product(a.y, c.x);
    sum.add_product(c.y, b.x);
    return sum.sign();
}

}  // namespace lancer::io
