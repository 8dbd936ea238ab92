// Splits a part of the tree in two, by one thread or by several, with the same result.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "tracer/bvh/bins.h"

namespace lancer::bvh_detail {

constexpr std::uint32_t parallel_boxes = 1 << 16;  ///< one thread splits smaller parts

/// A split makes two passes over the boxes. The first one counts them into bins. The second one
/// writes the boxes on each side of the best plane to their places in the other array. Boxes on
/// each side keep their order. So several threads can each process a range, and the bins of the
/// ranges tell where its boxes go.
template <class Number>
class Splitter {
  public:
    using Cut = std::pair<Part<Number>, Part<Number>>;

    explicit Splitter(BothSides<Number>& boxes) : boxes_(boxes) {}

    /// Splits at the heuristic's best plane, or at the median. `part.count` >= 2.
    Cut operator()(const Part<Number>& part, int threads) {
        if (part.depth < bvh_sah_levels) {
            const Binning<Number> binning(part.centers);
            const std::size_t stretches = threads > 1 && part.count > parallel_boxes
                                              ? 4 * static_cast<std::size_t>(threads)
                                              : 1;
            if (stretches == 1) {
                Bins<Number> all;
                count(part, binning, 0, part.count, all);
                if (const Plane plane = all.best(); plane.exists()) {
                    Cut cut = sides(part, plane, all);
                    move(part, binning, plane, {0, part.count}, cut.first.first, cut.second.first,
                         cut.first.centers, cut.second.centers);
                    return cut;
                }
            } else if (const std::optional<Cut> cut = together(part, binning, stretches, threads)) {
                return *cut;
            }
        }
        return halves(part);
    }

  private:
    struct Stretch {
        std::uint32_t first, end;  ///< range within the part
    };

    void count(const Part<Number>& part, const Binning<Number>& binning, std::uint32_t first,
               std::uint32_t end, Bins<Number>& counted) const {
        const MovingBox<Number>* box = boxes_[part.side].get() + part.first;
        for (std::uint32_t i = first; i < end; ++i) counted.add(box[i], binning(box[i]));
    }

    /// Writes a range's boxes to the other array, from `left` and from `right` on.
    void move(const Part<Number>& part, const Binning<Number>& binning, const Plane& plane,
              const Stretch& stretch, std::uint32_t left, std::uint32_t right,
              Hull<Number>& left_centers, Hull<Number>& right_centers) {
        const MovingBox<Number>* box = boxes_[part.side].get() + part.first;
        MovingBox<Number>* to = boxes_[1 - part.side].get();
        Hull<Number> centers[2];
        std::uint32_t next[2] = {left, right};
        for (std::uint32_t i = stretch.first; i < stretch.end; ++i) {
            const std::size_t which = plane.has_left(binning(box[i])) ? 0 : 1;
            centers[which].extend(box[i].center(), box[i].center());
            to[next[which]++] = box[i];
        }
        left_centers = centers[0];
        right_centers = centers[1];
    }

    static Cut sides(const Part<Number>& part, const Plane& plane, const Bins<Number>& all) {
        const auto [left, right] = all.hulls(plane);
        const std::size_t side = 1 - part.side;
        return {
            {part.first, plane.left, part.depth + 1, side, left, {}},
            {part.first + plane.left, part.count - plane.left, part.depth + 1, side, right, {}}};
    }

    std::optional<Cut> together(const Part<Number>& part, const Binning<Number>& binning,
                                std::size_t stretches, int threads) {
        const auto stretch = [&](std::size_t i) {
            const auto at = [&](std::size_t k) {
                return static_cast<std::uint32_t>(std::uint64_t(part.count) * k / stretches);
            };
            return Stretch{at(i), at(i + 1)};
        };
        const auto for_each_stretch = [&](auto&& action) {
            for_each_task(static_cast<int>(stretches), threads, {}, [&](const NextTask& next) {
                for (int i = 0; next(i);) action(static_cast<std::size_t>(i));
            });
        };
        std::vector<Bins<Number>> counted(stretches);
        for_each_stretch([&](std::size_t i) {
            count(part, binning, stretch(i).first, stretch(i).end, counted[i]);
        });
        Bins<Number> all;
        for (const Bins<Number>& some : counted) all.add(some);
        const Plane plane = all.best();
        if (!plane.exists()) return std::nullopt;

        Cut cut = sides(part, plane, all);
        struct Target {
            std::uint32_t left, right;
            Hull<Number> left_centers, right_centers;
        };
        std::vector<Target> targets(stretches);
        std::uint32_t left = cut.first.first;
        std::uint32_t right = cut.second.first;
        for (std::size_t i = 0; i < stretches; ++i) {
            targets[i].left = left;
            targets[i].right = right;
            const std::uint32_t on_left = counted[i].left_of(plane);
            left += on_left;
            right += stretch(i).end - stretch(i).first - on_left;
        }
        for_each_stretch([&](std::size_t i) {
            Target& to = targets[i];
            move(part, binning, plane, stretch(i), to.left, to.right, to.left_centers,
                 to.right_centers);
        });
        for (const Target& to : targets) {
            cut.first.centers.extend(to.left_centers);
            cut.second.centers.extend(to.right_centers);
        }
        return cut;
    }

    /// If no plane separates anything: splits at the median along the longest axis.
    Cut halves(const Part<Number>& part) {
        const std::array<Number, 4> extent = (part.centers.high - part.centers.low).numbers();
        std::size_t axis = extent[0] > extent[1] ? 0 : 1;
        if (extent[2] > extent[axis]) axis = 2;
        MovingBox<Number>* box = boxes_[part.side].get() + part.first;
        const std::uint32_t left = part.count / 2;
        const auto place = [axis](const MovingBox<Number>& b) {
            const Number center = b.low[axis] + b.high[axis];
            return center == center ? center : Number(0);  // NaN if infinite in both directions
        };
        std::nth_element(box, box + left, box + part.count,
                         [&](const MovingBox<Number>& a, const MovingBox<Number>& b) {
                             const Number ca = place(a);
                             const Number cb = place(b);
                             return ca != cb ? ca < cb : a.item() < b.item();
                         });
        const auto half = [&](std::uint32_t first, std::uint32_t end) {
            Part<Number> one{part.first + first, end - first, part.depth + 1, part.side, {}, {}};
            for (std::uint32_t i = first; i < end; ++i) {
                one.box.extend(box[i]);
                one.centers.extend(box[i].center(), box[i].center());
            }
            return one;
        };
        return {half(0, left), half(left, part.count)};
    }

    BothSides<Number>& boxes_;
};

}  // namespace lancer::bvh_detail
