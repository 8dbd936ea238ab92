// Eight lines and a torus: shapes/torus_line.h for lanes, the same numbers.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// TorusPlace<double>
struct TorusPlaces {
    Numbers k, y, climb, f, slope, bend;
};

/// TorusLine<double>
class TorusLines {
  public:
    LANCER_INLINE TorusLines(const Torus& torus, const Rays& ray)
        : ring_(torus.ring), tube_(torus.tube) {
        const Numbers zero = all(0.0);
        const Numbers shrink = all(torus.shrink);
        const Vectors start = start_from(ray, {zero, zero, zero}) * shrink;
        dir_ = ray.dir * shrink;
        dd_ = dot(dir_, dir_);
        inverse_ = all(1.0) / dd_;
        slide_ = -dot(start, dir_) * inverse_;
        near_ = start + slide_ * dir_;
        const Numbers rest = -dot(near_, dir_) * inverse_;
        near_ = near_ + rest * dir_;
        slide_ = slide_ + rest;
        along_ = dot(near_, dir_);
        ll_ = dot(near_, near_);
        const Vectors size = absolute(start);
        const double reach = ring_ + tube_;
        weight_ = 4 * (ring_ * ring_);
        k0_ = ll_ - all(ring_ * ring_) - all(tube_ * tube_);
        const Numbers place =
            ray.origin_error * shrink + bound<6>() * ((size.x + size.y + size.z) + all(reach));
        k_error_ = place * (all(2 * reach) + place) + all(gamma<double, 32> * (reach * reach));
        y_error_ = place + all(gamma<double, 8> * reach);
        rounding_ =
            gamma<double, 4> * (weight_ * (tube_ * tube_) + 4 * (ring_ * tube_) * (reach * reach));
    }

    /// TorusSpans<double>, by lanes that have them. \return lanes with any
    struct Spans {
        Numbers from[2], to[2];
        Mask some[2];
    };
    LANCER_INLINE Spans spans() const {
        const Numbers zero = all(0.0);
        Spans found{{zero, zero}, {zero, zero}, {0, 0}};
        const Numbers middle = all(ring_ * ring_ + tube_ * tube_);
        const Numbers width = all(2 * ring_ * tube_) + all(8.0) * k_error_;
        const Numbers outer = (middle + width) - ll_;
        Mask active = less(zero, outer);
        if (active == 0) return found;
        Numbers high = root(outer * inverse_);
        Numbers low = -high;
        const Numbers half = all(tube_) + all(8.0) * y_error_;
        const Mask climbs = less(y_error_, absolute(dir_.y * high));
        active &= climbs | less(absolute(near_.y), half);
        const Numbers upright = all(1.0) / dir_.y;
        const Numbers a = (-half - near_.y) * upright;
        const Numbers b = (half - near_.y) * upright;
        const Mask up = less(a, b);
        low = select(climbs, larger(select(up, a, b), low), low);
        high = select(climbs, smaller(select(up, b, a), high), high);
        active &= less(low, high);
        const Numbers inner = (middle - width) - ll_;
        const Mask holed = less(zero, inner);
        const Numbers hole = select(holed, root(inner * inverse_), zero);
        const Mask open = less(zero, hole);
        found.some[0] = active & (~open | less(low, -hole));
        found.some[1] = active & open & less(hole, high);
        found.from[0] = low;
        found.to[0] = select(open, smaller(-hole, high), high);
        found.from[1] = larger(hole, low);
        found.to[1] = high;
        return found;
    }

    LANCER_INLINE Numbers ray_parameter(const Numbers& at) const { return at + slide_; }
    /// Where the rays start.
    LANCER_INLINE Numbers start() const { return all(0.0) - slide_; }

    /// next_root() from outside, for several rays.
    struct Search {
        Numbers at, to;
        Mask active;       ///< still on the way
        Mask found = 0;    ///< at a root
        Mask on_root = 0;  ///< at the start on the surface
        Numbers margin;    ///< f counts as smaller by so much
    };
    LANCER_INLINE void step(Search& s) const {
        const Numbers zero = all(0.0);
        TorusPlaces p = place(s.at);
        p.f = p.f - s.margin;
        const Mask arrived = s.active & ~s.on_root & ~less(zero, p.f);
        s.found |= arrived;
        s.active &= ~arrived;
        if (s.active == 0) return;
        const Numbers f = select(s.on_root, all(rounding_), p.f);
        const Numbers room = s.to - s.at;
        const Mask falls = less(p.slope, zero);
        const Numbers four = all(4.0);
        const Numbers two = all(2.0);
        Numbers stretch = smaller(all(-2.0) * f / p.slope, room);
        const Mask bends = ~falls & less(p.bend, zero) & s.active;
        stretch = select(falls, stretch, room);
        if (bends != 0) {
            const Numbers end = -(p.slope + root(p.slope * p.slope - four * p.bend * f)) / p.bend;
            stretch = select(bends, smaller(end, room), stretch);
        }
        const Numbers u = dd_ * stretch;
        const Numbers least = smaller(all(-2.0) * p.climb, u);
        const Numbers change = select(less(zero, least), least * (four * p.climb + least), zero);
        const Numbers c = p.bend + change;
        const Numbers square = p.slope * p.slope - four * c * f;
        const Mask ends = less(c, zero) | falls;
        const Numbers r = root(square);
        Numbers h = two * f / (r - p.slope);
        if ((s.active & ~falls) != 0) h = select(falls, h, -(p.slope + r) / (two * c));
        const Mask arrives = at_most(zero, square) & ends & at_most(h, stretch);
        const Numbers length = select(arrives, h, stretch);
        const Numbers v = dd_ * h;
        const Numbers rest = (h * h) * (v * (four * p.climb + v) - change);
        s.active &= less(length, room);
        const Numbers next = s.at + length;
        const Mask stays = equal(next, s.at);
        s.at = select(s.active, next, s.at);
        const Mask done = s.active & ((arrives & at_most(rest, all(rounding_))) | stays);
        s.found |= done;
        s.active &= ~done;
        s.on_root = 0;
    }

    /// How far a line stays inside at least from where it goes in: the next root's first step.
    /// Where the line bends inwards, a fixed length takes the place of the tangent's.
    LANCER_INLINE Numbers least_chord(const Numbers& at) const {
        const Numbers zero = all(0.0);
        const TorusPlaces p = place(at);
        const Numbers s = -p.slope;
        const Numbers least = all(2 * ring_ * tube_) * dd_;
        const Numbers stretch = all(2.0) * s / larger(p.bend, least);
        const Numbers u = dd_ * stretch;
        const Numbers c = p.bend + larger(u * (all(4.0) * p.climb + u), zero);
        const Numbers chord = select(less(zero, c), smaller(s / c, stretch), stretch);
        return select(less(zero, s), chord, zero);
    }

    /// What f is larger than wherever the scalar search finds no root. At its roots f is at most
    /// the noise there, which is largest where k and y are the tube's.
    LANCER_INLINE Numbers clear_margin() const {
        return all(32.0) * noise_at(all(2 * ring_ * tube_), all(tube_));
    }

    /// Which lines go in at a root that step() found, whatever rounding did: f falls there so
    /// steeply that its curvature changes less than a quarter of it on either side, until f is
    /// clear of its rounding error. The scalar search finds this root too, with an error that is
    /// below `near`.
    ///
    /// \param last  where nothing matters any more
    LANCER_INLINE Mask certainly_enter(const Numbers& at, const Numbers& last) const {
        const TorusPlaces p = place(at);
        const Numbers margin = clear_margin();
        const Numbers t = ray_parameter(at);
        const Numbers near =
            all(-16.0) * margin / p.slope + bound<16>() * (absolute(at) + absolute(slide_));
        return less(p.slope, all(0.0)) & less(all(16.0) * margin * most_bend(), p.slope * p.slope) &
               less(near, t) & less(t + near, last);
    }

    /// climbs_clear()
    LANCER_INLINE Mask climbs_clear(const Numbers& at) const {
        const TorusPlaces p = place(at);
        const Numbers noise = noise_at(p.k, p.y);
        return less(all(0.0), p.slope) & at_most(absolute(p.f), noise) &
               less(all(16.0) * noise * most_bend(), p.slope * p.slope);
    }

    /// Lines that are inside in the middle of a span whose ends they are as far from as the span is
    /// long: whatever rounding does, they go in between, by more than any bound.
    ///
    /// \param last  where nothing matters any more
    LANCER_INLINE Mask hold_middle(const Spans& spans, const Numbers& last) const {
        Mask inside = 0;
        for (int i = 0; i < 2; ++i) {
            if (spans.some[i] == 0) continue;
            const Numbers length = spans.to[i] - spans.from[i];
            const Numbers middle = spans.from[i] + length * all(0.5);
            const Mask clear = less(all(2.0) * length, ray_parameter(spans.from[i])) &
                               less(ray_parameter(spans.to[i]) + all(2.0) * length, last);
            if ((spans.some[i] & clear & ~inside) == 0) continue;
            const Numbers k = k_at(middle);
            const Numbers y = y_at(middle);
            inside |= spans.some[i] & clear & less(f_of(k, y), -noise_at(k, y));
        }
        return inside;
    }

    /// bound(), in the lanes of the mask.
    LANCER_INLINE Numbers error(const Numbers& at, Mask mask) const {
        const Numbers k = k_at(at);
        const Numbers y = y_at(at);
        const Numbers noise = noise_at(k, y);
        const Numbers slope = slope_of(k, y, climb_at(at));
        const Numbers steep = larger(absolute(slope), root(noise * most_bend()));
        Numbers e = all(2.0) * noise / steep;
        const Numbers most = all(2 * (ring_ + tube_)) / root(dd_);
        for (;;) {
            mask &= less(e, most) & ~(is_certain(at - e) & is_certain(at + e));
            if (mask == 0) break;
            e = select(mask, e * all(2.0), e);
        }
        return e + bound<4>() * (absolute(at) + absolute(slide_));
    }

  private:
    LANCER_INLINE TorusPlaces place(const Numbers& at) const {
        TorusPlaces p;
        p.climb = climb_at(at);
        p.k = k_at(at);
        p.y = y_at(at);
        p.f = f_of(p.k, p.y);
        p.slope = slope_of(p.k, p.y, p.climb);
        p.bend = all(4.0) * (p.climb * p.climb) + all(2.0) * (dd_ * p.k) +
                 all(weight_) * (dir_.y * dir_.y);
        return p;
    }
    LANCER_INLINE Numbers climb_at(const Numbers& at) const { return dd_ * at + along_; }
    LANCER_INLINE Numbers k_at(const Numbers& at) const {
        return (dd_ * at + all(2.0) * along_) * at + k0_;
    }
    LANCER_INLINE Numbers y_at(const Numbers& at) const { return near_.y + at * dir_.y; }
    LANCER_INLINE Numbers most_bend() const {
        const double reach = ring_ + tube_;
        return all(32.0) * dd_ * all(reach * reach);
    }
    LANCER_INLINE Numbers noise_at(const Numbers& k, const Numbers& y) const {
        const Numbers two = all(2.0);
        const Numbers weight = all(weight_);
        return k_error_ * (two * absolute(k) + k_error_) +
               weight * (y_error_ * (two * absolute(y) + y_error_)) +
               bound<6>() * (k * k + weight * (y * y + all(tube_ * tube_)));
    }
    LANCER_INLINE Mask is_certain(const Numbers& at) const {
        const Numbers k = k_at(at);
        const Numbers y = y_at(at);
        return less(noise_at(k, y), absolute(f_of(k, y)));
    }
    LANCER_INLINE Numbers f_of(const Numbers& k, const Numbers& y) const {
        return k * k + all(weight_) * ((y - all(tube_)) * (y + all(tube_)));
    }
    LANCER_INLINE Numbers slope_of(const Numbers& k, const Numbers& y, const Numbers& climb) const {
        return all(4.0) * (k * climb) + all(2.0) * (all(weight_) * y) * dir_.y;
    }

    double ring_, tube_, weight_, rounding_;
    Vectors dir_, near_;
    Numbers slide_, dd_, inverse_, along_, ll_, k0_, k_error_, y_error_;
};

}  // namespace lancer::wide::LANCER_LEVEL
