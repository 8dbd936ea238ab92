// The crossings of eight rays with one cylinder or cone in world space: all_crossings() of
// shapes/frustum.h for lanes.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// frustum_face
inline constexpr std::uint32_t frustum_side = 0;
inline constexpr std::uint32_t small_cap = 1;
inline constexpr std::uint32_t large_cap = 2;

/// What is known of the starts of rays: IntersectionHints. Nothing, unless the frustum is a medium.
struct FrustumStart {
    Mask inside = 0;                               ///< rays that are in the frustum
    Mask on_side = 0, on_small = 0, on_large = 0;  ///< of these, rays that start on a face of it

    FrustumStart() = default;
    LANCER_INLINE FrustumStart(const Starts& starts, std::uint32_t item, Mask rays) : inside(rays) {
        const Mask own = rays & equal(starts.item, item);
        on_side = own & equal(starts.face, frustum_side);
        on_small = own & equal(starts.face, small_cap);
        on_large = own & equal(starts.face, large_cap);
    }
};

/// The parts of lines inside a frustum; for a frustum without caps, where they cross its side.
class FrustumCrossings {
  public:
    Numbers in = all(-infinity);
    Numbers out = all(infinity);
    Mask enters = 0;  ///< lines that cross at `in`
    Mask leaves = 0;  ///< lines that cross at `out`
    Mask unsure = 0;  ///< lines that the exact method must compute

    /// \param last   crossings beyond this parameter may be missing
    /// \param start  rays that start on the frustum must be inside of it
    LANCER_INLINE FrustumCrossings(const Frustum& f, const Rays& r, Mask active,
                                   const Numbers& last, const FrustumStart& start = {})
        : frustum_(f), rays_(r), from_(start) {
        cut(active, last);
        // Rounding hides the way out.
        unsure |= active & from_.inside & ~met_;
    }

    /// Bounds on the errors of `in`.
    Numbers in_error() const { return bound_of(in, side_enters_, forward_, enters); }
    /// Bounds on the errors of `out`.
    Numbers out_error() const { return bound_of(out, side_leaves_, ~forward_, leaves); }

    std::uint32_t in_face(int i) const { return face(side_enters_, forward_, i); }
    std::uint32_t out_face(int i) const { return face(side_leaves_, ~forward_, i); }

  private:
    /// Sets the public members.
    LANCER_INLINE void cut(Mask active, const Numbers& last) {
        const Frustum& f = frustum_;
        const Vectors axis = all(f.axis);
        start_ = start_from(rays_, all(f.small_end));
        start_axial_ = dot(axis, start_);
        start_perp_ = start_ - start_axial_ * axis;
        dir_axial_ = dot(axis, rays_.dir);
        dir_perp_ = rays_.dir - dir_axial_ * axis;
        active &= cut_by_caps(active);
        active &= ~less(last, in);
        if (active == 0) return;
        Numbers side_in, side_out;
        active = cut_by_side(active, side_in, side_out);
        if (active == 0) return;
        if (f.capped) {
            side_enters_ = ~less(side_in, in);
            side_leaves_ = ~less(out, side_out);
            in = select(side_enters_, side_in, in);
            out = select(side_leaves_, side_out, out);
            enters = leaves = met_ = active & ~less(out, in);
        } else {
            const auto is_between = [&](const Numbers& t) {
                return at_most(in, t) & at_most(t, out);
            };
            enters = active & is_between(side_in);
            leaves = active & is_between(side_out);
            in = side_in;
            out = side_out;
            side_enters_ = side_leaves_ = 255;
        }
        enters &= less(absolute(in), all(infinity)) & ~less(last, in);
        leaves &= less(absolute(out), all(infinity)) & ~less(last, out);
    }

    /// Sets `in` and `out` to the parts of the lines between the planes of the caps.
    ///
    /// \return lines with such a part
    LANCER_INLINE Mask cut_by_caps(Mask active) {
        const Numbers zero = all(0.0);
        from_large_ = start_from(rays_, all(frustum_.large_end));
        const Numbers to_small = -start_axial_;
        const Numbers to_large = -dot(all(frustum_.axis), from_large_);
        const Mask still = equal(dir_axial_, zero);
        forward_ = less(zero, dir_axial_);
        const Numbers small = select(from_.on_small, zero, to_small / dir_axial_);
        const Numbers large = select(from_.on_large, zero, to_large / dir_axial_);
        in = select(still, in, select(forward_, small, large));
        out = select(still, out, select(forward_, large, small));
        return active & ~(still & (less(zero, to_small) | less(to_large, zero)));
    }

    /// side_span(), where no divisor is 0. Other lines become unsure.
    ///
    /// \return lines that meet the side
    LANCER_INLINE Mask cut_by_side(Mask active, Numbers& side_in, Numbers& side_out) {
        const Numbers zero = all(0.0);
        const Numbers slope = all(frustum_.slope);
        const Numbers dd = dot(dir_perp_, dir_perp_);
        rate_ = slope * dir_axial_;
        qa_ = dd - rate_ * rate_;
        slide_ = select(less(zero, dd), -dot(start_perp_, dir_perp_) / dd, zero);
        slide_ = select(less(in, slide_), slide_, in);
        slide_ = select(less(slide_, out), slide_, out);
        slide_ = select(less(absolute(slide_), all(infinity)) & ~from_.on_side, slide_, zero);
        const Vectors o = start_perp_ + slide_ * dir_perp_;
        const Numbers radius = all(frustum_.radius) + slope * (start_axial_ + slide_ * dir_axial_);
        const Numbers qb = dot(o, dir_perp_) - radius * rate_;
        const Numbers qc = dot(o, o) - radius * radius;
        const Vectors v = radius * dir_perp_ - rate_ * o;
        const Numbers moment = dot(all(frustum_.axis), cross(o, dir_perp_));
        discriminant_ = dot(v, v) - moment * moment;
        const Mask grows = less(zero, qa_);  // the line is outside beyond the roots
        const Mask outside = less(discriminant_, zero) & ~from_.on_side;
        active &= ~(outside & grows);
        discriminant_ = select(outside, zero, discriminant_);
        root_ = root(discriminant_);
        const Numbers q = -(qb + with_sign(root_, qb));
        // From a start on the side: how far the other crossing is.
        const Numbers other = from_.on_side == 0 ? zero : all(-2.0) * qb / qa_;
        const Numbers most = select(from_.on_side, other, q);
        unsure = active & ~(less(absolute(most), all(infinity)) &
                            (from_.on_side | ~equal(q, zero)) & (grows | less(qa_, zero)));
        active &= ~unsure;
        if (active == 0) return 0;
        const Numbers r0 = select(from_.on_side, other, q / qa_);
        const Numbers r1 = select(from_.on_side, zero, qc / q);
        const Mask first = less(r0, r1);
        divided_ = r0 + slide_;
        const Numbers low = select(first, r0, r1) + slide_;
        const Numbers high = select(first, r1, r0) + slide_;
        // A line that is steeper than the side is inside the double cone beyond the roots. The
        // solid is the nappe towards which the radius grows.
        const Mask widens = less(zero, rate_);
        side_in = select(grows, low, select(widens, high, all(-infinity)));
        side_out = select(grows, high, select(widens, all(infinity), low));
        return active;
    }

    LANCER_INLINE Numbers bound_of(const Numbers& t, Mask side, Mask small, Mask mask) const {
        Numbers error = all(0.0);
        if ((mask & side) != 0) error = side_bound(t);
        if ((mask & ~side) == 0) return error;
        return select(side, error, cap_bound(t, small));
    }

    LANCER_INLINE Numbers side_bound(const Numbers& t) const {
        const Frustum& f = frustum_;
        const Numbers far = absolute(t);
        Numbers place = rays_.origin_error + all(f.transform_error) +
                        bound<4>() * (length(start_perp_) + all(f.radius));
        if (f.tilted)
            place =
                place + (bound<8>() * length(start_) + bound<8>() * root(rays_.dir_squared) * far);
        if (f.slope != 0)
            place = place + bound<6>() * all(f.slope) *
                                (absolute(start_axial_) + absolute(slide_ * dir_axial_));
        const Numbers size =
            absolute(all(f.radius) + all(f.slope) * (start_axial_ + t * dir_axial_)) *
            all(1 + f.slope);
        const Numbers w = place * (all(2.0) * size + place);
        const Numbers steep = absolute(qa_);
        const Numbers terms = length(dir_perp_) + absolute(rate_);
        Numbers along = select(less(all(4.0) * steep * w, discriminant_), all(0.54) * w / root_,
                               root(w / steep));
        if (from_.on_side != 0) {
            const Numbers left_of_dir = f.tilted ? bound<8>() * root(rays_.dir_squared) : all(0.0);
            const Numbers turned = left_of_dir * (size + terms * far);
            const Numbers from_side = all(2.0) * (place * terms + turned) / steep;
            along = select(from_.on_side, from_side, along);
        }
        const Numbers by_quotient = bound<4>() * (terms * terms / steep) * absolute(t - slide_);
        along = select(equal(t, divided_), along + by_quotient, along);
        return along + bound<6>() * (far + absolute(slide_));
    }

    /// \param small  the lanes that cross the small cap
    LANCER_INLINE Numbers cap_bound(const Numbers& t, Mask small) const {
        const Vectors steep = absolute(all(frustum_.axis));
        const Vectors from_end = select(small, start_, from_large_);
        const Numbers height = rays_.origin_error + all(frustum_.transform_error) +
                               bound<4>() * dot(steep, absolute(from_end));
        const Numbers rate = bound<3>() * dot(steep, absolute(rays_.dir));
        return (height + rate * absolute(t)) / absolute(dir_axial_) + bound<3>() * absolute(t);
    }

    static std::uint32_t face(Mask side, Mask small, int i) {
        if ((side >> i & 1) != 0) return frustum_side;
        return (small >> i & 1) != 0 ? small_cap : large_cap;
    }

    const Frustum& frustum_;
    const Rays& rays_;
    const FrustumStart from_;
    Mask met_ = 0;                ///< lines that meet a frustum with caps
    Vectors start_, from_large_;  ///< the rays' starts, relative to the small and the large end
    Vectors start_perp_, dir_perp_;
    Numbers start_axial_, dir_axial_;
    Mask forward_ = 0;  ///< lines that go from the small end to the large one
    Mask side_enters_ = 0, side_leaves_ = 0;
    // SideSpan
    Numbers slide_, qa_, discriminant_, root_, divided_, rate_;
};

/// Adds the crossings of rays that do not start on an opaque frustum.
///
/// \param around  OtherShape::around
/// \return rays that the exact method must compute; nothing is added for them
[[gnu::noinline]] inline Mask frustum_crossings(const Ball& around, const Frustum& f,
                                                std::uint32_t item, const Rays& r, Mask active,
                                                NearestHits& hits) {
    active = may_come_near(around, r, active, hits.limit);
    if (active == 0) return 0;
    const FrustumGuess guess(f, r, active, hits.limit);
    if (guess.unsettled == 0) return 0;
    const FrustumCrossings c(f, r, guess.unsettled, hits.limit);
    if (c.enters != 0) {
        for_each_lane(hits.add_ahead(c.enters, c.in, c.in_error(), item, 255),
                      [&](int i) { hits.face[i] = c.in_face(i); });
    }
    const Mask leaves = c.leaves & ~less(hits.limit, c.out);
    if (leaves != 0) {
        for_each_lane(hits.add_ahead(leaves, c.out, c.out_error(), item, 0),
                      [&](int i) { hits.face[i] = c.out_face(i); });
    }
    return c.unsure;
}

/// The same for a frustum that is a medium, and rays that may start on it: those outside can only
/// enter, those inside only leave. A ray that has left does not enter again: frustums are convex.
[[gnu::noinline]] inline Mask crossings_of_clear(const Frustum& f, std::uint32_t item,
                                                 const Rays& r, const Starts& starts, Mask active,
                                                 const Ways& ways, NearestHits& hits) {
    const Mask inside = active & ways.inside;
    Mask asked = active & ~inside & ~equal(starts.item, item);
    if (asked != 0) asked = FrustumGuess(f, r, asked, hits.limit).unsettled;
    asked |= inside;
    if (asked == 0) return 0;
    const FrustumCrossings c(f, r, asked, hits.limit, FrustumStart(starts, item, inside));
    if (const Mask enters = c.enters & ~inside; enters != 0) {
        for_each_lane(hits.add_ahead(enters, c.in, c.in_error(), item, 255),
                      [&](int i) { hits.face[i] = c.in_face(i); });
    }
    if (const Mask leaves = c.leaves & inside; leaves != 0) {
        for_each_lane(hits.add_ahead(leaves, c.out, c.out_error(), item, 0),
                      [&](int i) { hits.face[i] = c.out_face(i); });
    }
    return c.unsure;
}

/// Whether an opaque frustum hides the light from eight rays that do not start on it.
struct FrustumShadow {
    Mask blocks = 0;
    Mask unsure = 0;

    /// \param around  OtherShape::around
    LANCER_INLINE FrustumShadow(const Ball& around, const Frustum& f, const Rays& r, Mask active,
                                const Numbers& distance) {
        active = may_come_near(around, r, active, distance);
        if (active == 0) return;
        const FrustumGuess guess(f, r, active, distance);
        blocks = guess.between;
        const Mask left = guess.unsettled & ~blocks;
        if (left != 0) look(f, r, left, distance);
    }

  private:
    [[gnu::noinline]] void look(const Frustum& f, const Rays& r, Mask active,
                                const Numbers& distance) {
        const FrustumCrossings c(f, r, active, distance);
        unsure = c.unsure;
        const auto note = [&](Mask mask, const Numbers& t, const Numbers& error) {
            const Mask ahead = less(error, t);
            blocks |= mask & ahead & less(t, distance - error);
            unsure |= mask & ~ahead & ~less(t, -error);
        };
        if (c.enters != 0) note(c.enters, c.in, c.in_error());
        const Mask leaves = c.leaves & ~blocks;
        if (leaves != 0) note(leaves, c.out, c.out_error());
        unsure &= ~blocks;
    }
};

}  // namespace lancer::wide::LANCER_LEVEL
