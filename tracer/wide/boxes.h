// Intersects eight rays with one box in world space: shapes/box.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// The parts of lines inside a box: BoxSpan.
struct BoxSpans {
    Numbers in = all(-infinity);
    Numbers out = all(infinity);
    Numbers in_error, out_error;  ///< bounds on the errors of `in` and `out`
    Mask met;                     ///< lines that meet the box

    LANCER_INLINE BoxSpans(const Box& box, const Rays& r, Mask active) : met(active) {
        in_steep_ = out_steep_ = all(0.0);
        cut(0, box, r, r.origin.x, r.origin_lo.x, r.dir.x, r.inv_dir.x);
        cut(1, box, r, r.origin.y, r.origin_lo.y, r.dir.y, r.inv_dir.y);
        cut(2, box, r, r.origin.z, r.origin_lo.z, r.dir.z, r.inv_dir.z);
        met &= ~less(out, in);
        if (met == 0) return;
        const Numbers place = r.origin_error + all(box.transform_error);
        in_error = bound<4>() * absolute(in) + place * in_steep_;
        out_error = bound<4>() * absolute(out) + place * out_steep_;
    }

    std::uint32_t in_face(int i) const { return face(in_axis_, i, false); }
    std::uint32_t out_face(int i) const { return face(out_axis_, i, true); }

  private:
    LANCER_INLINE void cut(int axis, const Box& box, const Rays& r, const Numbers& origin,
                           const Numbers& origin_lo, const Numbers& dir, const Numbers& inverse) {
        const auto way_to = [&](double plane) {
            const Numbers plain = all(plane) - origin;
            if (r.whole == 255) return plain;
            const NumberPair d = two_sum(all(plane), all(0.0) - origin);
            return select(r.whole, plain, d.hi + (d.lo - origin_lo));
        };
        const Numbers to_min = way_to(box.min[axis]);
        const Numbers to_max = way_to(box.max[axis]);
        const Numbers zero = all(0.0);
        const Mask still = equal(dir, zero);
        met &= ~(still & (less(zero, to_min) | less(to_max, zero)));
        forward_[axis] = less(zero, dir);
        const Numbers at_min = to_min * inverse;
        const Numbers at_max = to_max * inverse;
        const Numbers near = select(forward_[axis], at_min, at_max);
        const Numbers far = select(forward_[axis], at_max, at_min);
        const Numbers steep = absolute(inverse);
        const Mask later = less(in, near) & ~still;
        in = select(later, near, in);
        in_steep_ = select(later, steep, in_steep_);
        const Mask sooner = less(far, out) & ~still;
        out = select(sooner, far, out);
        out_steep_ = select(sooner, steep, out_steep_);
        for (int before = 0; before < axis; ++before) {
            in_axis_[before] &= ~later;
            out_axis_[before] &= ~sooner;
        }
        in_axis_[axis] = later;
        out_axis_[axis] = sooner;
    }

    std::uint32_t face(const Mask* axes, int i, bool is_out) const {
        for (int axis = 0; axis < 3; ++axis) {
            if ((axes[axis] >> i & 1) == 0) continue;
            const bool forward = (forward_[axis] >> i & 1) != 0;
            return static_cast<std::uint32_t>(2 * axis + (forward == is_out ? 1 : 0));
        }
        return 0;
    }

    Numbers in_steep_, out_steep_;
    Mask in_axis_[3], out_axis_[3], forward_[3];
};

/// Adds the crossings of rays that do not start on the box.
///
/// \return rays inside the box that miss it because of rounding; nothing is added for them
LANCER_INLINE Mask box_crossings(const Box& box, std::uint32_t item, const Rays& r, Mask active,
                                 const Ways& ways, NearestHits& hits) {
    const BoxSpans span(box, r, active);
    const auto offer = [&](Mask way, const Numbers& t, const Numbers& error, Mask entering) {
        const Mask asked = span.met & way & less(absolute(t), all(infinity)) & ~less(hits.limit, t);
        return hits.add_ahead(asked, t, error, item, entering);
    };
    const Mask lost = active & ways.inside & ~span.met;
    if (span.met == 0) return lost;
    for_each_lane(offer(ways.in, span.in, span.in_error, 255),
                  [&](int i) { hits.face[i] = span.in_face(i); });
    for_each_lane(offer(ways.out, span.out, span.out_error, 0),
                  [&](int i) { hits.face[i] = span.out_face(i); });
    return lost;
}

/// Whether the box hides the light from eight rays that do not start on it.
struct BoxShadow {
    Mask blocks = 0;
    Mask unsure = 0;

    LANCER_INLINE BoxShadow(const Box& box, const Rays& r, Mask active, const Numbers& distance) {
        const BoxSpans span(box, r, active);
        if (span.met == 0) return;
        const auto look = [&](const Numbers& t, const Numbers& error) {
            const Mask finite = span.met & less(absolute(t), all(infinity));
            const Mask ahead = less(error, t);
            blocks |= finite & ahead & less(t, distance - error);
            unsure |= finite & ~ahead & ~less(t, -error);
        };
        look(span.in, span.in_error);
        look(span.out, span.out_error);
        unsure &= ~blocks;
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
