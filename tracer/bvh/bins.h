// The surface-area heuristic with bins. Wald, "On fast Construction of SAH-based Bounding Volume
// Hierarchies", RT 2007.
#pragma once

#include <bit>
#include <utility>

#include "tracer/bvh/moving_boxes.h"

namespace lancer::bvh_detail {

constexpr std::size_t bins = 16;

/// The bin of a box on each axis, by its centre.
template <class Number>
class Binning {
  public:
    explicit Binning(const Hull<Number>& centers) : from_(centers.low), scale_(Number(0)) {
        std::array<Number, 4> scale{};
        const std::array<Number, 4> extent = (centers.high - centers.low).numbers();
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (extent[axis] > 0) scale[axis] = static_cast<Number>(bins) / extent[axis];
        scale_ = Four<Number>(scale);
    }

    /// NaNs, and numbers that rounding puts beyond the last bin, are clamped to a bin.
    std::array<Number, 4> operator()(const MovingBox<Number>& box) const {
        const Four<Number> place = (box.center() - from_) * scale_;
        return smaller(larger(place, Four<Number>(Number(0))), Four<Number>(Number(bins - 1)))
            .numbers();
    }

  private:
    Four<Number> from_;
    Four<Number> scale_;
};

/// A plane between two bins.
struct Plane {
    std::size_t axis = 3;    ///< 3: no plane separates anything
    std::size_t last = 0;    ///< the last bin on its left
    std::uint32_t left = 0;  ///< number of boxes on its left

    bool exists() const { return axis < 3; }
    template <class Number>
    bool has_left(const std::array<Number, 4>& place) const {
        return static_cast<std::size_t>(place[axis]) <= last;
    }
};

/// For each bin of all axes the hull and the number of its boxes. Most bins of a small part are
/// empty; these are neither cleared nor visited.
template <class Number>
class Bins {
  public:
    void add(const MovingBox<Number>& box, const std::array<Number, 4>& place) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            put(axis, static_cast<std::size_t>(place[axis]), box, 1);
    }
    void add(const Bins& other) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for_each(other.filled_[axis], [&](std::size_t i) {
                put(axis, i, other.box_[axis][i], other.count_[axis][i]);
            });
        }
    }

    std::uint32_t left_of(const Plane& plane) const {
        std::uint32_t sum = 0;
        for_each(filled_[plane.axis] & ((2U << plane.last) - 1),
                 [&](std::size_t i) { sum += count_[plane.axis][i]; });
        return sum;
    }
    std::pair<Hull<Number>, Hull<Number>> hulls(const Plane& plane) const {
        std::pair<Hull<Number>, Hull<Number>> both;
        for_each(filled_[plane.axis], [&](std::size_t i) {
            (i <= plane.last ? both.first : both.second).extend(box_[plane.axis][i]);
        });
        return both;
    }

    /// The cheapest of the 3 x 15 planes between bins.
    Plane best() const {
        Plane best;
        Area<Number> best_cost = std::numeric_limits<Area<Number>>::infinity();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<Area<Number>, bins> right_cost;
            Hull<Number> hull;
            std::uint32_t count = 0;
            for (unsigned left = filled_[axis]; left != 0;) {
                const auto i = static_cast<std::size_t>(std::bit_width(left) - 1);
                left ^= 1U << i;
                hull.extend(box_[axis][i]);
                count += count_[axis][i];
                right_cost[i] = hull.half_area() * static_cast<Area<Number>>(count);
            }
            hull = {};
            count = 0;
            for (unsigned left = filled_[axis]; left != 0;) {
                const auto i = static_cast<std::size_t>(std::countr_zero(left));
                left &= left - 1;
                if (left == 0) break;
                hull.extend(box_[axis][i]);
                count += count_[axis][i];
                const Area<Number> cost =
                    hull.half_area() * static_cast<Area<Number>>(count) +
                    right_cost[static_cast<std::size_t>(std::countr_zero(left))];
                if (cost < best_cost) {
                    best_cost = cost;
                    best = {axis, i, count};
                }
            }
        }
        return best;
    }

  private:
    template <class Action>
    static void for_each(unsigned bits, Action&& action) {
        for (; bits != 0; bits &= bits - 1)
            action(static_cast<std::size_t>(std::countr_zero(bits)));
    }

    void put(std::size_t axis, std::size_t i, const MovingBox<Number>& box, std::uint32_t count) {
        if ((filled_[axis] >> i & 1) == 0) {
            filled_[axis] |= 1U << i;
            box_[axis][i] = box;
            count_[axis][i] = count;
        } else {
            MovingBox<Number>& grown = box_[axis][i];
            grown.low = smaller(Four<Number>(box.low), Four<Number>(grown.low)).numbers();
            grown.high = larger(Four<Number>(box.high), Four<Number>(grown.high)).numbers();
            count_[axis][i] += count;
        }
    }

    // Uninitialised unless the bin's bit in filled_ is set.
    MovingBox<Number> box_[3][bins];
    std::uint32_t count_[3][bins];
    unsigned filled_[3] = {};
};

}  // namespace lancer::bvh_detail
