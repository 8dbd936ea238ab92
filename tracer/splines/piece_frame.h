// A piece of a patch in coordinates that follow it, and what they tell of a line before the
// piece's points are looked at.
//
// A piece is nearly a parallelogram: in coordinates along its own two directions and across them,
// u and v are its parameters but for a shift and a little, and the height is nearly nothing. Seen
// along a line, the map whose zeros PlaneZeros finds is, after the change of the plane that makes
// its mean slopes the identity, in real numbers
//     q = (u(p), v(p)) - (u(o), v(o)) - k (h(p) - h(o)),   k = (u(d), v(d)) / h(d),
// for a point p of the piece and the line o + t d. Bounds on the coordinates and on their slopes,
// made once for the piece, therefore bound q and its slopes for every line.
//
// That is a filter before PlaneZeros, whose answers it foresees (docs/performance.md). It speaks of
// such lines alone as are no closer to the piece's mean plane than to let rounding be covered:
//  - PlaneZeros reports no zero at which q is farther from 0 than 4 of its slacks, `noise` times
//    the sum of the sizes of a row of the plane's map. Here a slack is 32 such: that covers the
//    other's rounding, and the rounding here. A place is at most `away` + `size` from the patch's
//    anchor, and noise >= 8 u away + 32 u size. Coordinates err by 5 u of that, each; k errs by 3 u
//    of itself and of |d| / h(d), both at most 16-fold by the condition on h(d), times a height.
//    These are at most 16 noise together, of each row's sums.
//  - Slopes of coordinates err by 8 u size of a row, which is less than 1/500 where a slack is
//    below 1/16; so where the bound here on the contraction's factor is 0.7, PlaneZeros finds one
//    below 0.75. It then halves nothing, and there is at most one zero.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "tracer/numerics/rounding.h"
#include "tracer/splines/pieces.h"

namespace lancer::splines {

template <class Real>
struct PieceFrame {
    explicit PieceFrame(const Piece<Real>& piece) {
        using std::abs;
        const auto mean = mean_frame(piece);
        if (!mean) return;
        row = *mean;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3<Real> sizes = absolute(row[k]);
            row_size[k] = sizes.x + sizes.y + sizes.z;
            std::array<Real, 16> c;
            for (std::size_t i = 0; i < 16; ++i) c[i] = dot(row[k], control_point(piece, i));
            low[k] = high[k] = c[0];
            for (const Real x : c) {
                low[k] = std::min(low[k], x);
                high[k] = std::max(high[k], x);
            }
            middle[k] = ((c[0] + c[3]) + (c[12] + c[15])) / 4;
            Real off_u = 0;
            Real off_v = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = 0; j < 3; ++j) {
                    const std::size_t along = 4 * i + j;
                    const std::size_t across = 4 * j + i;
                    const Real by_u = 3 * (c[along + 1] - c[along]) - Real(k == 0 ? 1 : 0);
                    const Real by_v = 3 * (c[across + 4] - c[across]) - Real(k == 1 ? 1 : 0);
                    off_u = std::max(off_u, abs(by_u));
                    off_v = std::max(off_v, abs(by_v));
                }
            }
            uneven[k] = off_u + off_v;
        }
        for (const auto& c : piece.c) {
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = 0; j < 3; ++j) {
                    const Real along = abs(c[4 * i + j + 1] - c[4 * i + j]);
                    const Real across = abs(c[4 * (j + 1) + i] - c[4 * j + i]);
                    slope = std::max(slope, 3 * std::max(along, across));
                }
            }
        }
    }

    /// A place has the coordinates dot(row[k], place): u, v, height. All 0 where a piece has no
    /// mean plane, of which nothing is then foreseen.
    std::array<Vec3<Real>, 3> row{Vec3<Real>(0), Vec3<Real>(0), Vec3<Real>(0)};
    std::array<Real, 3> row_size{};     ///< sums of the sizes of a row's numbers
    std::array<Real, 3> low{}, high{};  ///< of the piece's coordinates
    std::array<Real, 3> middle{};       ///< the corners' mean, where u = v = 1/2
    std::array<Real, 3> uneven{};       ///< how far slopes differ from 1 and 0: sum of both
    Real slope = 0;                     ///< the largest size of a component of a derivative
};

/// A line as a piece sees it.
template <class Real>
class PieceView {
  public:
    /// \param origin  of the line, relative to the piece's patch
    /// \param noise   as PlaneZeros gets it
    PieceView(const PieceFrame<Real>& frame, const Vec3<Real>& origin, const Vec3<Real>& dir,
              Real noise)
        : frame_(frame), origin_(origin), dir_(dir), noise_(noise) {
        using std::abs;
        rise_ = dot(frame.row[2], dir);
        if (!(abs(rise_) * 16 >= frame.row_size[2] * max_component(absolute(dir))) || rise_ == 0)
            return;
        per_rise_ = 1 / rise_;
        height_ = dot(frame.row[2], origin);
        Real factor = 0;
        Real most_slack = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            slide_[k] = dot(frame.row[k], dir) * per_rise_;
            place_[k] = dot(frame.row[k], origin) - slide_[k] * height_;
            const Real lean = abs(slide_[k]);
            factor = std::max(factor, frame.uneven[k] + lean * frame.uneven[2]);
            slack_[k] = 32 * noise * (frame.row_size[k] + lean * frame.row_size[2]);
            most_slack = std::max(most_slack, slack_[k]);
        }
        is_clear = factor <= Real(0.7) && most_slack <= Real(1) / 16;
    }

    /// The line meets the piece once or not at all. Nothing else here says anything where it is
    /// not clear.
    bool is_clear = false;

    /// PlaneZeros would report nothing.
    bool passes_by() const {
        for (std::size_t k = 0; k < 2; ++k) {
            const Real a = slide_[k] * frame_.low[2];
            const Real b = slide_[k] * frame_.high[2];
            if (frame_.low[k] - std::max(a, b) - place_[k] > slack_[k]) return true;
            if (frame_.high[k] - std::min(a, b) - place_[k] < -slack_[k]) return true;
        }
        return false;
    }

    /// Parameters of the line between which a crossing must lie, with eight of its error bounds on
    /// either side. Such a bound is that of the place, and the slack of u and v, 2 / (1 - factor)
    /// of PlaneZeros' own, times the slope along the line's largest component, over this component;
    /// and 3 u of the parameter.
    std::pair<Real, Real> stretch() const {
        using std::abs;
        const Real a = (frame_.low[2] - height_) * per_rise_;
        const Real b = (frame_.high[2] - height_) * per_rise_;
        const Real along = max_component(absolute(dir_));
        const Real moved = noise_ + frame_.slope * (slack_[0] + slack_[1]);
        const Real error = 8 * (moved / along + 32 * noise_ * frame_.row_size[2] * abs(per_rise_) +
                                gamma<Real>(8) * std::max(abs(a), abs(b)));
        return {std::min(a, b) - error, std::max(a, b) + error};
    }

    /// Whether the piece is met for certain. The steps u - q of a contraction lead to its zero,
    /// which is at most |q| / (1 - factor) away: where that is within the square, the zero is, too.
    /// (0.7 for the factor, and 4 > 1 / 0.3.)
    bool meets(const Piece<Real>& piece) const {
        using std::abs;
        std::array<Real, 2> at;
        for (std::size_t k = 0; k < 2; ++k)
            at[k] = Real(0.5) + (place_[k] + slide_[k] * frame_.middle[2]) - frame_.middle[k];
        for (int step = 0; step < 3; ++step) {
            for (const Real s : at)
                if (!(s > 0 && s < 1)) return false;
            const CubicBasis<Real> bu(at[0]);
            const CubicBasis<Real> bv(at[1]);
            Vec3<Real> p;
            for (int c = 0; c < 3; ++c)
                p[c] = BicubicValue<Real>(piece.c[static_cast<std::size_t>(c)], bu, bv).value;
            const Real height = dot(frame_.row[2], p);
            Real away = 0;
            Real room = 1;
            for (std::size_t k = 0; k < 2; ++k) {
                const Real q = dot(frame_.row[k], p) - slide_[k] * height - place_[k];
                away = std::max(away, abs(q) + slack_[k]);
                room = std::min({room, at[k] - 2 * slack_[k], 1 - at[k] - 2 * slack_[k]});
                at[k] -= q;
            }
            if (4 * away < room) return true;
        }
        return false;
    }

  private:
    const PieceFrame<Real>& frame_;
    const Vec3<Real>& origin_;
    const Vec3<Real>& dir_;
    Real noise_;
    Real rise_;  ///< of the height along the line
    Real per_rise_ = 0;
    Real height_ = 0;              ///< of the origin
    std::array<Real, 2> slide_{};  ///< k
    std::array<Real, 2> place_{};  ///< where the line meets the height 0
    std::array<Real, 2> slack_{};
};

}  // namespace lancer::splines
