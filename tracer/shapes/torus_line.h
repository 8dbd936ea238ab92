// A line and a torus: where they cross.
#pragma once

#include <algorithm>
#include <array>

#include "tracer/rays/ray.h"
#include "tracer/shapes/traits.h"

namespace lancer {

/// All points whose distance from the ring, a circle about the origin across the y axis, is at most
/// that of the tube. Measures are those of the solid's own space times `shrink`.
template <class Real>
struct TorusSolid {
    Real ring;        ///< the circle's radius, near 1
    Real tube;        ///< > 0, <= ring
    Real shrink = 1;  ///< a power of two
    Real grow = 1;    ///< 1 / shrink

    static constexpr SolidTraits traits{.convex = false, .face_by_face = false};
    /// The smallest measure in its own space.
    Real size() const { return tube * grow; }
    Real reach() const { return ring + tube; }
};

/// Parameters of a line between which it may be inside.
template <class Real>
struct TorusSpans {
    std::array<std::array<Real, 2>, 2> at{};
    int count = 0;

    void add(Real from, Real to) { at[static_cast<std::size_t>(count++)] = {from, to}; }
};

/// The surface along a line, as a function of the line's parameter t whose sign tells the inside:
/// with the ring's radius R and the tube's r,
///     f = k^2 + 4 R^2 (y^2 - r^2),    k = |p|^2 - R^2 - r^2,
/// which is what the textbook's quartic (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2) comes to when its
/// terms of the size R^4 are taken out by hand (Hanrahan, "A survey of ray-surface intersection
/// algorithms", in: Glassner (ed.), An Introduction to Ray Tracing (1989), has that). What is left
/// vanishes with the tube: all terms are at most of the size (R r)^2 near the surface, so a tube of
/// a billionth of its ring keeps its digits. f is never expanded: k and y are, which are of the
/// second degree and the first.
template <class Real>
struct TorusPlace {
    Real k, y;
    Real climb;  ///< half of the derivative of k
    Real f, slope;
    Real bend;  ///< half of the second derivative of f
};

/// A line in the torus' scale, its start slid along itself to where it is nearest to the centre.
template <class Real>
class TorusLine {
  public:
    /// Of a span no more are looked for: four, and what rounding makes of them.
    static constexpr int most_roots = 8;

    TorusLine(const TorusSolid<Real>& torus, const Ray<Real>& ray) : torus_(torus) {
        const Vec3<Real> start = start_from(ray, Vec3<Real>(0)) * torus.shrink;
        dir_ = ray.dir * torus.shrink;
        dd_ = dot(dir_, dir_);
        const Real inverse = 1 / dd_;
        slide_ = -dot(start, dir_) * inverse;
        near_ = start + slide_ * dir_;
        // Once more: from far away roundings of the start's size are left along the line.
        const Real rest = -dot(near_, dir_) * inverse;
        near_ += rest * dir_;
        slide_ += rest;
        along_ = dot(near_, dir_);
        ll_ = dot(near_, near_);
        const Vec3<Real> size = absolute(start);
        const Real reach = torus.reach();
        weight_ = 4 * (torus.ring * torus.ring);
        k0_ = ll_ - torus.ring * torus.ring - torus.tube * torus.tube;
        const Real place =
            ray.origin_error * torus.shrink + gamma<Real>(6) * ((size.x + size.y + size.z) + reach);
        // What k is off by: the line's displacement, and some roundings of its terms.
        k_error_ = place * (2 * reach + place) + gamma<Real>(32) * (reach * reach);
        y_error_ = place + gamma<Real>(8) * reach;
        rounding_ = gamma<Real>(4) * (weight_ * (torus.tube * torus.tube) +
                                      4 * (torus.ring * torus.tube) * (reach * reach));
    }

    /// The parameters between which the line may be inside: it is near the plane of the ring, and
    /// between two balls about the centre. f is positive at their ends, beyond all doubt: k and y
    /// are taken to where they leave the tube by more than they can be off.
    TorusSpans<Real> spans() const {
        using std::abs;
        using std::sqrt;
        TorusSpans<Real> found;
        const Real middle = torus_.ring * torus_.ring + torus_.tube * torus_.tube;
        const Real width = 2 * torus_.ring * torus_.tube + 8 * k_error_;
        const Real outer = (middle + width) - ll_;
        if (!(outer > 0)) return found;
        const Real inverse = 1 / dd_;
        Real high = sqrt(outer * inverse);
        Real low = -high;
        const Real half = torus_.tube + 8 * y_error_;
        // Where the line climbs by less than a rounding of the tube it is as good as level.
        const Real climb = dir_.y * high;
        if (abs(climb) > y_error_) {
            const Real upright = 1 / dir_.y;
            const Real a = (-half - near_.y) * upright;
            const Real b = (half - near_.y) * upright;
            low = std::max(low, a < b ? a : b);
            high = std::min(high, a < b ? b : a);
        } else if (!(abs(near_.y) < half)) {
            return found;
        }
        if (!(low < high)) return found;
        const Real inner = (middle - width) - ll_;
        const Real hole = inner > 0 ? sqrt(inner * inverse) : Real(0);
        if (!(hole > 0)) {
            found.add(low, high);
            return found;
        }
        if (low < -hole) found.add(low, std::min(high, -hole));
        if (high > hole) found.add(std::max(low, hole), high);
        return found;
    }

    /// The parameter of the ray, and back.
    Real ray_parameter(Real at) const { return at + slide_; }
    Real parameter_of(Real t) const { return t - slide_; }

    /// Moves `at` to the next root of f before `to`. False: there is none.
    ///
    /// Each step ends where a parabola that lies below |f| does, so it never passes a root, and
    /// near one it is as good as Newton's (Kalra, Barr, "Guaranteed ray intersections with implicit
    /// surfaces", SIGGRAPH 1989, do so with a line; f is of the fourth degree, so that its Taylor
    /// series ends, and the parabola that is below it on a stretch follows from four numbers).
    ///
    /// \param outside  whether f is positive before the root
    /// \param on_root  `at` is a root of the other kind, or the start on the surface
    bool next_root(Real& at, Real to, bool outside, bool on_root) const {
        for (;; on_root = false) {
            const TorusPlace<Real> p = place(at);
            const Real f = outside ? p.f : -p.f;
            // Where a root is known f is rounding: with that much of it the next step is one.
            if (!on_root && !(f > 0)) return true;
            const Real room = to - at;
            const Step step = step_from(p, on_root ? rounding_ : f, outside, room);
            if (!(step.length < room)) {
                if (outside || !(room > 0)) return false;
                const Real before = at;
                at += room / 2;  // it leaves before the end, whatever rounding made of that
                if (at == before) return true;
                continue;
            }
            const Real before = at;
            at += step.length;
            if ((step.arrives && step.rest <= rounding_) || at == before) return true;
        }
    }

    /// Whether f, which is all rounding at `at`, is clear of it after the next root, and has no
    /// other next to it.
    bool climbs_clear(Real at, Real to) const {
        using std::abs;
        const TorusPlace<Real> p = place(at);
        const Real noise = noise_at(p.k, p.y);
        return p.slope > 0 && abs(p.f) <= noise && at < to &&
               p.slope * p.slope > 16 * noise * most_bend();
    }

    /// Bounds the error of a root: on both sides of it, that far away, the sign of f is certain.
    /// Between such places the true surface is crossed; where the line but touches it, both of its
    /// roots lie there, or none.
    Real bound(Real at) const {
        using std::abs;
        using std::sqrt;
        const Real k = k_at(at);
        const Real y = y_at(at);
        const Real noise = noise_at(k, y);
        const Real slope = 4 * (k * climb_at(at)) + 2 * (weight_ * y) * dir_.y;
        const Real least = sqrt(noise * most_bend());
        const Real steep = abs(slope) > least ? abs(slope) : least;
        Real error = 2 * noise / steep;
        const Real most = 2 * torus_.reach() / sqrt(dd_);
        while (error < most && !(is_certain(at - error) && is_certain(at + error))) error *= 2;
        return error + gamma<Real>(4) * (abs(at) + abs(slide_));
    }

  private:
    struct Step {
        Real length;
        Real rest = 0;         ///< how far |f| is from 0 there at most
        bool arrives = false;  ///< the parabola ends there
    };

    /// How far from a place |f| has no root.
    ///
    ///     f(t + h) = f + s h + b h^2 + d h^3 (4 a + d h)
    ///
    /// with slope s, half of the second derivative b, half of that of k a, and the square of the
    /// direction d. On a stretch of length H the last term is at least d h^2 times the least value
    /// of h (4 a + d h), and at most d h^2 times the largest or 0.
    ///
    /// H is short, which makes the parabola a good one: twice as far as where the tangent ends,
    /// where a double root of a parabola is; from a root on, twice as far as the other root.
    Step step_from(const TorusPlace<Real>& p, Real f, bool outside, Real room) const {
        using std::sqrt;
        const Real s = outside ? p.slope : -p.slope;
        const Real b = outside ? p.bend : -p.bend;
        Real stretch = room;
        if (s < 0)
            stretch = std::min(room, -2 * f / s);
        else if (b < 0)
            stretch = std::min(room, -(s + sqrt(s * s - 4 * b * f)) / b);
        const Real u = dd_ * stretch;
        Real change = 0;
        if (outside) {
            const Real least = std::min(u, -2 * p.climb);
            if (least > 0) change = least * (4 * p.climb + least);
        } else {
            change = -std::max(Real(0), u * (4 * p.climb + u));
        }
        const Real c = b + change;
        const Real square = s * s - 4 * c * f;
        if (!(square >= 0) || (s >= 0 && !(c < 0))) return {stretch};
        const Real root = sqrt(square);
        const Real h = s < 0 ? 2 * f / (root - s) : -(s + root) / (2 * c);
        if (!(h <= stretch)) return {stretch};
        const Real v = dd_ * h;
        const Real third = v * (4 * p.climb + v);
        return {h, (h * h) * ((outside ? third : -third) - change), true};
    }

    TorusPlace<Real> place(Real at) const {
        TorusPlace<Real> p;
        p.climb = climb_at(at);
        p.k = k_at(at);
        p.y = y_at(at);
        const Real weighted = weight_ * p.y;
        p.f = p.k * p.k + weight_ * ((p.y - torus_.tube) * (p.y + torus_.tube));
        p.slope = 4 * (p.k * p.climb) + 2 * weighted * dir_.y;
        p.bend = 4 * (p.climb * p.climb) + 2 * (dd_ * p.k) + weight_ * (dir_.y * dir_.y);
        return p;
    }
    Real climb_at(Real at) const { return dd_ * at + along_; }
    Real k_at(Real at) const { return (dd_ * at + 2 * along_) * at + k0_; }
    Real y_at(Real at) const { return near_.y + at * dir_.y; }
    /// The second derivative of f is nowhere larger near the torus.
    Real most_bend() const { return 32 * dd_ * (torus_.reach() * torus_.reach()); }
    /// What f is off by for lines as near to this one as rounding may have moved it.
    Real noise_at(Real k, Real y) const {
        using std::abs;
        return k_error_ * (2 * abs(k) + k_error_) + weight_ * (y_error_ * (2 * abs(y) + y_error_)) +
               gamma<Real>(6) * (k * k + weight_ * (y * y + torus_.tube * torus_.tube));
    }
    bool is_certain(Real at) const {
        using std::abs;
        const Real k = k_at(at);
        const Real y = y_at(at);
        const Real f = k * k + weight_ * ((y - torus_.tube) * (y + torus_.tube));
        return abs(f) > noise_at(k, y);
    }

    const TorusSolid<Real>& torus_;
    Vec3<Real> dir_;
    Vec3<Real> near_;  ///< the point nearest to the centre
    Real slide_;       ///< the ray's parameter there
    Real dd_;          ///< dir·dir
    Real along_;       ///< near·dir: what rounding left of it
    Real ll_;          ///< near·near
    Real weight_;      ///< 4 R^2
    Real k0_;          ///< k at the parameter 0
    Real k_error_;
    Real y_error_;
    Real rounding_;  ///< of f at its roots, for this line as it is
};

}  // namespace lancer
