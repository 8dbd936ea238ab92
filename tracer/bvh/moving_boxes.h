// What the builder of trees moves: boxes that carry the number of their item along.
//
// Each pass over a part of the tree reads its boxes from one end to the other. Were they looked up
// by their items' numbers, every one would be a miss of the cache, level after level. They have the
// number type of the nodes, rounded outwards: half the memory for a tree in double, and nothing
// lost, because a node holds no more digits.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>

#include "tracer/bvh/bvh.h"
#include "tracer/numerics/lanes.h"

namespace lancer {

/// The largest number of the boxes' type that is not above x.
template <class Real>
BoxNumber<Real> at_most_as_large(Real x) {
    using Number = BoxNumber<Real>;
    const auto rounded = static_cast<Number>(x);
    if constexpr (std::is_same_v<Number, Real>) {
        return rounded;
    } else {
        if (!(static_cast<Real>(rounded) > x)) return rounded;
        // The next one below: the bits of a float count in steps of its last place.
        if (rounded == 0) return -std::numeric_limits<Number>::denorm_min();
        const auto bits = std::bit_cast<std::uint32_t>(rounded);
        return std::bit_cast<Number>(rounded > 0 ? bits - 1 : bits + 1);
    }
}

namespace bvh_detail {

/// Three coordinates of each corner. The fourth numbers are the item's, in two halves that even a
/// float holds, so that a box is 32 bytes of float and goes through vectors whole.
template <class Number>
struct MovingBox {
    std::array<Number, 4> low;
    std::array<Number, 4> high;

    MovingBox() = default;  // no numbers: memory that a split writes to needs none
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
    /// Twice the centre: the factor changes no order.
    Four<Number> center() const { return Four<Number>(low) + Four<Number>(high); }
};

/// Of boxes in float in double: small boxes among large ones have squares that float does not.
template <class Number>
using Area = std::conditional_t<(sizeof(Number) < sizeof(double)), double, Number>;

/// What holds some boxes or points. The fourth numbers mean nothing.
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

    /// Half the surface: what the surface-area heuristic compares.
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

/// The boxes twice: a split reads from one side and writes to the same places of the other.
template <class Number>
using BothSides = std::array<std::unique_ptr<MovingBox<Number>[]>, 2>;

/// Boxes that lie together on one of both sides, and belong below one child of a node.
template <class Number>
struct Part {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    int depth = 0;
    std::size_t side = 0;
    Hull<Number> box{};
    Hull<Number> centers{};  ///< of their centers()
};

}  // namespace bvh_detail
}  // namespace lancer
