// A piece of a patch in coordinates along its own directions: a filter for lines that does not need
// the piece's points.
//
// A piece is nearly a parallelogram. Let u and v be coordinates along its two mean directions, and
// h the height across them. Then u and v are nearly its parameters, up to a shift, and h is nearly
// 0. PlaneZeros searches for zeros of the piece's projection along a line o + t d. After the linear
// map of the plane that makes the projection's mean slopes the identity, the projection of a point
// p of the piece is, in real numbers,
//     q = (u(p), v(p)) - (u(o), v(o)) - k (h(p) - h(o)),   k = (u(d), v(d)) / h(d).
// So bounds on the coordinates and on their slopes, computed once per piece, give bounds on q and
// its slopes for every line.
//
// This filter predicts the results of PlaneZeros (docs/performance.md). It decides only for lines
// that are not too close to the direction of the piece's mean plane. Rounding errors are covered:
//  - PlaneZeros reports no zero at which q is farther from 0 than 4 of its slacks; such a slack is
//    `noise` times the sum of the sizes in a row of the plane's map. A slack here is 32 times as
//    large, which covers the rounding errors there and here. A point is at most `away` + `size`
//    from the patch's anchor, and noise >= 8 u away + 32 u size. Each coordinate has an error of 5
//    u of that. k has an error of 3 u of itself and of |d| / h(d), times a height; by the condition
//    on h(d), both are at most 16-fold. Together these errors are at most 16 noise times each row's
//    sum.
//  - Slopes of coordinates have an error of 8 u size of a row. This is less than 1/500 if a slack
//  is
//    below 1/16. So if the bound here on the contraction's factor is 0.7, PlaneZeros finds a factor
//    below 0.75. It then does not subdivide, and there is at most one zero.
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

    /// The coordinates u, v and height of a point p are dot(row[k], p). All rows are 0 if the piece
    /// has no mean plane; the filter then decides nothing.
    std::array<Vec3<Real>, 3> row{Vec3<Real>(0), Vec3<Real>(0), Vec3<Real>(0)};
    std::array<Real, 3> row_size{};     ///< per row the sum of the sizes of its numbers
    std::array<Real, 3> low{}, high{};  ///< bounds on the piece's coordinates
    std::array<Real, 3> middle{};       ///< the mean of the corners, where u = v = 1/2
    std::array<Real, 3> uneven{};       ///< largest deviations of both slopes from 1 and 0, summed
    Real slope = 0;                     ///< the largest absolute component of a derivative
};

/// A line in the coordinates of a piece.
template <class Real>
class PieceView {
  public:
    /// \param origin  the line's origin, relative to the anchor of the piece's patch
    /// \param noise   the noise that PlaneZeros gets
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

    /// The line meets the piece at most once. If false, the other functions have no meaning.
    bool is_clear = false;

    /// Whether PlaneZeros would certainly report nothing.
    bool passes_by() const {
        for (std::size_t k = 0; k < 2; ++k) {
            const Real a = slide_[k] * frame_.low[2];
            const Real b = slide_[k] * frame_.high[2];
            if (frame_.low[k] - std::max(a, b) - place_[k] > slack_[k]) return true;
            if (frame_.high[k] - std::min(a, b) - place_[k] < -slack_[k]) return true;
        }
        return false;
    }

    /// An interval of the line's parameter that must contain a crossing, with eight of its error
    /// bounds on either side. Such an error bound is the sum of two parts. The first is the noise,
    /// plus the slack of u and v (2 / (1 - factor) of PlaneZeros' own slack) times the slope along
    /// the line's largest component, all divided by this component. The second is 3 u of the
    /// parameter.
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

    /// Whether the line certainly meets the piece. The steps u - q of a contraction converge to its
    /// zero, which is at most |q| / (1 - factor) away. If this distance is within the square, the
    /// zero is as well. (The factor is at most 0.7, and 4 > 1 / 0.3.)
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
    Real rise_;                    ///< h(d), the rate of the height along the line
    Real per_rise_ = 0;            ///< 1 / rise_
    Real height_ = 0;              ///< h(o), the height of the origin
    std::array<Real, 2> slide_{};  ///< k
    std::array<Real, 2> place_{};  ///< u and v of the line at height 0
    std::array<Real, 2> slack_{};
};

}  // namespace lancer::splines
