// The boxes that the tree builder moves; each contains the number of its item.
//
// Each pass over a part of the tree reads its boxes in the order of memory. If boxes were found by
// the numbers of their items, each access would miss the cache, on every level. The boxes have the
// number type of the nodes, rounded outwards. This halves the memory for a tree in double, and
// loses nothing, because nodes have no more digits.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>

#include "tracer/bvh/bvh.h"
#include "tracer/numerics/lanes.h"

namespace lancer {

/// The largest number of the boxes' type that is at most x.
template <class Real>
BoxNumber<Real> at_most_as_large(Real x) {
    using Number = BoxNumber<Real>;
    const auto rounded = static_cast<Number>(x);
    if constexpr (std::is_same_v<Number, Real>) {
        return rounded;
    } else {
        if (!(static_cast<Real>(rounded) > x)) return rounded;
        // The next number below: as integers, the bits of floats count units in the last place.
        if (rounded == 0) return -std::numeric_limits<Number>::denorm_min();
        const auto bits = std::bit_cast<std::uint32_t>(rounded);
        return std::bit_cast<Number>(rounded > 0 ? bits - 1 : bits + 1);
    }
}

namespace bvh_detail {

/// The first three numbers of each array are coordinates of a corner. The fourth numbers are the
/// two halves of the item's number, which are exact even in float. So a box in float has 32 bytes,
/// and vector instructions can move it as a whole.
template <class Number>
struct MovingBox {
    std::array<Number, 4> low;
    std::array<Number, 4> high;

    MovingBox() = default;  // uninitialised: for memory that a split writes to
    template <class Real>
    MovingBox(const Bounds<Real>& box, std::uint32_t item) {
        for (int i = 0; i < 3; ++i) {
            low[static_cast<std::size_t>(i)] = at_most_as_large<Real>(box.min[i]);
            high[static_cast<std::size_t>(i)] = -at_most_as_large<Real>(-box.max[i]);
        }
        low[3] = static_cast<Number>(item & 0xFFFF);
        high[3] = static_cast<Number>(item >> 16);
    }

    std::uint32_t item() const {
        return static_cast<std::uint32_t>(low[3]) | static_cast<std::uint32_t>(high[3]) << 16;
    }
    /// Twice the centre; the factor does not change any order.
    Four<Number> center() const { return Four<Number>(low) + Four<Number>(high); }
};

/// The type of areas. For boxes in float it is double, because the squares of small boxes among
/// large ones underflow float.
template <class Number>
using Area = std::conditional_t<(sizeof(Number) < sizeof(double)), double, Number>;

/// The bounds of some boxes or points. The fourth numbers have no meaning.
template <class Number>
struct Hull {
    Four<Number> low{std::numeric_limits<Number>::infinity()};
    Four<Number> high{-std::numeric_limits<Number>::infinity()};

    void extend(const Four<Number>& least, const Four<Number>& most) {
        low = smaller(least, low);
        high = larger(most, high);
    }
    void extend(const Hull& other) { extend(other.low, other.high); }
    void extend(const MovingBox<Number>& box) {
        extend(Four<Number>(box.low), Four<Number>(box.high));
    }

    /// Half the surface area, as the surface-area heuristic compares it.
    Area<Number> half_area() const {
        const std::array<Number, 4> side = (high - low).numbers();
        const auto d = [&](std::size_t axis) { return static_cast<Area<Number>>(side[axis]); };
        return d(0) * d(1) + d(1) * d(2) + d(2) * d(0);
    }
    template <class Real>
    Bounds<Real> bounds() const {
        const std::array<Number, 4> least = low.numbers();
        const std::array<Number, 4> most = high.numbers();
        return {{least[0], least[1], least[2]}, {most[0], most[1], most[2]}};
    }
};

/// Two arrays of boxes: a split reads from one and writes to the same range of the other.
template <class Number>
using BothSides = std::array<std::unique_ptr<MovingBox<Number>[]>, 2>;

/// A contiguous range of boxes in one of the two arrays (`side`), which belong below one child of a
/// node.
template <class Number>
struct Part {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    int depth = 0;
    std::size_t side = 0;
    Hull<Number> box{};
    Hull<Number> centers{};  ///< bounds of their center()s
};

}  // namespace bvh_detail
}  // namespace lancer
