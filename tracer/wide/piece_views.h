// Eight lines as a piece of a patch sees them: splines/piece_frame.h for lanes. The proofs are
// there.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// CubicBasis<double>
struct CubicBases {
    Numbers value[4], slope[4];

    LANCER_INLINE explicit CubicBases(const Numbers& s) {
        const Numbers two = all(2.0);
        const Numbers three = all(3.0);
        const Numbers r = all(1.0) - s;
        const Numbers rr = r * r;
        const Numbers rs = r * s;
        const Numbers ss = s * s;
        value[0] = rr * r;
        value[1] = three * rr * s;
        value[2] = three * r * ss;
        value[3] = ss * s;
        slope[0] = all(-3.0) * rr;
        slope[1] = three * (rr - two * rs);
        slope[2] = three * (two * rs - ss);
        slope[3] = three * ss;
    }
};

LANCER_INLINE Numbers weighted(const Numbers& a, const Numbers& b, const Numbers& c,
                               const Numbers& d, const Numbers (&weight)[4]) {
    return a * weight[0] + b * weight[1] + c * weight[2] + d * weight[3];
}

/// BicubicValue<double>: the same polynomial at eight places.
struct BicubicValues {
    Numbers value, du, dv;

    LANCER_INLINE BicubicValues(const double (&c)[16], const CubicBases& u, const CubicBases& v) {
        value = du = dv = all(0.0);
        for (int i = 0; i < 4; ++i) {
            const double* row = c + 4 * i;
            const Numbers at =
                weighted(all(row[0]), all(row[1]), all(row[2]), all(row[3]), u.value);
            const Numbers slope =
                weighted(all(row[0]), all(row[1]), all(row[2]), all(row[3]), u.slope);
            value = value + v.value[i] * at;
            du = du + v.value[i] * slope;
            dv = dv + v.slope[i] * at;
        }
    }
};

/// PieceView<double>
class PieceViews {
  public:
    /// \param origin  of the lines, relative to the piece's patch
    /// \param along   the largest components of `dir`
    /// \param noise   as PlaneZeros gets it
    LANCER_INLINE PieceViews(const PieceFrame& frame, const Vectors& origin, const Vectors& dir,
                             const Numbers& along, const Numbers& noise)
        : frame_(frame), along_(along), noise_(noise) {
        const Numbers zero = all(0.0);
        const Numbers rise = dot(all(frame.row[2]), dir);
        clear_ = at_most(all(frame.row_size[2]) * along, absolute(rise) * all(16.0)) &
                 ~equal(rise, zero);
        if (clear_ == 0) return;
        per_rise_ = all(1.0) / rise;
        height_ = dot(all(frame.row[2]), origin);
        Numbers factor = zero;
        Numbers most_slack = zero;
        for (int k = 0; k < 2; ++k) {
            slide_[k] = dot(all(frame.row[k]), dir) * per_rise_;
            place_[k] = dot(all(frame.row[k]), origin) - slide_[k] * height_;
            const Numbers lean = absolute(slide_[k]);
            factor = larger(all(frame.uneven[k]) + lean * all(frame.uneven[2]), factor);
            slack_[k] =
                all(32.0) * noise * (all(frame.row_size[k]) + lean * all(frame.row_size[2]));
            most_slack = larger(slack_[k], most_slack);
        }
        clear_ &= at_most(factor, all(0.7)) & at_most(most_slack, all(1.0 / 16));
    }

    /// The lines that meet the piece once or not at all. Of others nothing is said here.
    LANCER_INLINE Mask clear() const { return clear_; }

    LANCER_INLINE Mask passes_by() const {
        Mask passes = 0;
        for (int k = 0; k < 2; ++k) {
            const Numbers a = slide_[k] * all(frame_.low[2]);
            const Numbers b = slide_[k] * all(frame_.high[2]);
            passes |= less(slack_[k], all(frame_.low[k]) - larger(a, b) - place_[k]);
            passes |= less(all(frame_.high[k]) - smaller(a, b) - place_[k], -slack_[k]);
        }
        return passes;
    }

    struct Stretch {
        Numbers first, last;
    };
    LANCER_INLINE Stretch stretch() const {
        const Numbers a = (all(frame_.low[2]) - height_) * per_rise_;
        const Numbers b = (all(frame_.high[2]) - height_) * per_rise_;
        const Numbers moved = noise_ + all(frame_.slope) * (slack_[0] + slack_[1]);
        const Numbers error =
            all(8.0) *
            (moved / along_ + all(32.0) * noise_ * all(frame_.row_size[2]) * absolute(per_rise_) +
             bound<8>() * larger(absolute(a), absolute(b)));
        return {smaller(a, b) - error, larger(a, b) + error};
    }

    /// The lines of the mask that meet the piece for certain.
    LANCER_INLINE Mask meets(const PatchPiece& piece, Mask mask) const {
        const Numbers zero = all(0.0);
        const Numbers one = all(1.0);
        const Numbers two = all(2.0);
        Numbers at[2];
        for (int k = 0; k < 2; ++k)
            at[k] =
                all(0.5) + (place_[k] + slide_[k] * all(frame_.middle[2])) - all(frame_.middle[k]);
        Mask met = 0;
        for (int step = 0; step < 3; ++step) {
            for (const Numbers& s : at) mask &= less(zero, s) & less(s, one);
            if (mask == 0) break;
            const CubicBases bu(at[0]);
            const CubicBases bv(at[1]);
            const Vectors p{BicubicValues(piece.c[0], bu, bv).value,
                            BicubicValues(piece.c[1], bu, bv).value,
                            BicubicValues(piece.c[2], bu, bv).value};
            const Numbers height = dot(all(frame_.row[2]), p);
            Numbers away = zero;
            Numbers room = one;
            for (int k = 0; k < 2; ++k) {
                const Numbers q = dot(all(frame_.row[k]), p) - slide_[k] * height - place_[k];
                away = larger(absolute(q) + slack_[k], away);
                const Numbers edge = two * slack_[k];
                room = smaller(smaller(at[k] - edge, one - at[k] - edge), room);
                at[k] = at[k] - q;
            }
            const Mask found = mask & less(all(4.0) * away, room);
            met |= found;
            mask &= ~found;
        }
        return met;
    }

  private:
    const PieceFrame& frame_;
    const Numbers& along_;
    const Numbers& noise_;
    Mask clear_;
    Numbers per_rise_, height_;
    Numbers slide_[2], place_[2], slack_[2];
};

}  // namespace lancer::wide::LANCER_LEVEL
