// The crossings of a line with a torus.
#pragma once

#include <algorithm>
#include <array>

#include "tracer/rays/ray.h"
#include "tracer/shapes/traits.h"

namespace lancer {

/// All points whose distance from the ring is at most the radius of the tube. The ring is a circle
/// about the origin, perpendicular to the y axis. Lengths are those of the solid's own space times
/// `shrink`.
template <class Real>
struct TorusSolid {
    Real ring;        ///< radius of the circle, near 1
    Real tube;        ///< radius of the tube, > 0, <= ring
    Real shrink = 1;  ///< a power of two
    Real grow = 1;    ///< 1 / shrink

    static constexpr SolidTraits traits{.convex = false, .face_by_face = false};
    /// The measure in its own space that must not be too small.
    Real size() const { return tube * grow; }
    Real reach() const { return ring + tube; }
};

/// Intervals of a line's parameter on which it may be inside.
template <class Real>
struct TorusSpans {
    std::array<std::array<Real, 2>, 2> at{};
    int count = 0;

    void add(Real from, Real to) { at[static_cast<std::size_t>(count++)] = {from, to}; }
};

/// The implicit function f of the torus at one parameter t of a line. f is negative inside. With
/// the ring's radius R and the tube's radius r,
///     f = k^2 + 4 R^2 (y^2 - r^2),    k = |p|^2 - R^2 - r^2.
/// This is the textbook quartic (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2), after its terms of the
/// size R^4 have been cancelled by hand (Hanrahan, "A survey of ray-surface intersection
/// algorithms", in: Glassner (ed.), An Introduction to Ray Tracing (1989), has the quartic). Near
/// the surface the remaining terms are at most of the size (R r)^2, so even a tube of a billionth
/// of its ring keeps its digits. f is never expanded to a polynomial in t; only k (degree 2) and y
/// (degree 1) are.
template <class Real>
struct TorusPlace {
    Real k, y;
    Real climb;  ///< half of the derivative of k
    Real f, slope;
    Real bend;  ///< half of the second derivative of f in t
};

/// A line in the scale of the torus. Its start slides along the line to the point nearest to the
/// centre.
template <class Real>
class TorusLine {
  public:
    /// The largest number of roots in a span: four, or more because of rounding.
    static constexpr int most_roots = 8;

    TorusLine(const TorusSolid<Real>& torus, const Ray<Real>& ray) : torus_(torus) {
        const Vec3<Real> start = start_from(ray, Vec3<Real>(0)) * torus.shrink;
        dir_ = ray.dir * torus.shrink;
        dd_ = dot(dir_, dir_);
        const Real inverse = 1 / dd_;
        slide_ = -dot(start, dir_) * inverse;
        near_ = start + slide_ * dir_;
        // A second time: if the start is far away, its rounding errors leave a part along the line.
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
        // The error of k: from the line's displacement, and from some roundings of the terms.
        k_error_ = place * (2 * reach + place) + gamma<Real>(32) * (reach * reach);
        y_error_ = place + gamma<Real>(8) * reach;
        rounding_ = gamma<Real>(4) * (weight_ * (torus.tube * torus.tube) +
                                      4 * (torus.ring * torus.tube) * (reach * reach));
    }

    /// The spans on which the line may be inside: there it is near the plane of the ring, and
    /// between two balls about the centre. At their ends f is certainly positive, because there k
    /// and y are outside of the tube's range by more than their errors.
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
        // A line that climbs by less than the rounding error of the tube counts as level.
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

    /// Converts between the line's parameter and the ray's.
    Real ray_parameter(Real at) const { return at + slide_; }
    Real parameter_of(Real t) const { return t - slide_; }

    /// Moves `at` to the next root of f before `to`. Returns false if there is none.
    ///
    /// Each step ends at the zero of a parabola that is a lower bound of |f|. So it never passes a
    /// root, and near a root it converges like Newton's method. Kalra, Barr, "Guaranteed ray
    /// intersections with implicit surfaces", SIGGRAPH 1989, use a line in place of the parabola.
    /// Here f has degree 4, so its Taylor series is finite, and the parabola on an interval follows
    /// from four numbers.
    ///
    /// \param outside  whether f is positive before the root
    /// \param on_root  whether `at` is a root of the other kind, or the start on the surface
    bool next_root(Real& at, Real to, bool outside, bool on_root) const {
        for (;; on_root = false) {
            const TorusPlace<Real> p = place(at);
            const Real f = outside ? p.f : -p.f;
            // At a known root f is only rounding error; that bound replaces it for the first step.
            if (!on_root && !(f > 0)) return true;
            const Real room = to - at;
            const Step step = step_from(p, on_root ? rounding_ : f, outside, room);
            if (!(step.length < room)) {
                if (outside || !(room > 0)) return false;
                const Real before = at;
                at += room / 2;  // the exit lies before the end, even if rounding hides it
                if (at == before) return true;
                continue;
            }
            const Real before = at;
            at += step.length;
            if ((step.arrives && step.rest <= rounding_) || at == before) return true;
        }
    }

    /// Whether f, which is below its rounding error at `at`, rises above it without another root
    /// nearby.
    bool climbs_clear(Real at, Real to) const {
        using std::abs;
        const TorusPlace<Real> p = place(at);
        const Real noise = noise_at(p.k, p.y);
        return p.slope > 0 && abs(p.f) <= noise && at < to &&
               p.slope * p.slope > 16 * noise * most_bend();
    }

    /// Bounds the error of a root: at this distance on both sides of it, the sign of f is certain.
    /// Between these points the line crosses the true surface. If it only touches the surface, both
    /// roots lie there, or none.
    Real bound(Real at) const {
        using std::abs;
        using std::sqrt;
        const Real k = k_at(at);
        const Real y = y_at(at);
        const Real noise = noise_at(k, y);
        const Real slope = slope_of(k, y, climb_at(at));
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
        Real rest = 0;         ///< bound on |f| at the end of the step
        bool arrives = false;  ///< the step ends at the zero of the parabola
    };

    /// A step on which f has no root.
    ///
    ///     f(t + h) = f + s h + b h^2 + d h^3 (4 a + d h)
    ///
    /// Here s is the slope, b half of the second derivative, a half of the derivative of k
    /// (`climb`), and d the square of the direction. On an interval of length H the last term is at
    /// least d h^2 times the least value of h (4 a + d h), and at most d h^2 times its largest
    /// value or 0.
    ///
    /// A short H makes the parabola a good bound. It is twice the length to the zero of the
    /// tangent, where a parabola has a double root; or, from a root on, twice the length to the
    /// other root.
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
        p.f = f_of(p.k, p.y);
        p.slope = slope_of(p.k, p.y, p.climb);
        p.bend = 4 * (p.climb * p.climb) + 2 * (dd_ * p.k) + weight_ * (dir_.y * dir_.y);
        return p;
    }
    Real climb_at(Real at) const { return dd_ * at + along_; }
    Real k_at(Real at) const { return (dd_ * at + 2 * along_) * at + k0_; }
    Real y_at(Real at) const { return near_.y + at * dir_.y; }
    Real f_of(Real k, Real y) const {
        return k * k + weight_ * ((y - torus_.tube) * (y + torus_.tube));
    }
    Real slope_of(Real k, Real y, Real climb) const {
        return 4 * (k * climb) + 2 * (weight_ * y) * dir_.y;
    }
    /// The second derivative of f is nowhere larger near the torus.
    Real most_bend() const { return 32 * dd_ * (torus_.reach() * torus_.reach()); }
    /// A bound on the error of f: on its change when rounding moves the line.
    Real noise_at(Real k, Real y) const {
        using std::abs;
        return k_error_ * (2 * abs(k) + k_error_) + weight_ * (y_error_ * (2 * abs(y) + y_error_)) +
               gamma<Real>(6) * (k * k + weight_ * (y * y + torus_.tube * torus_.tube));
    }
    bool is_certain(Real at) const {
        using std::abs;
        const Real k = k_at(at);
        const Real y = y_at(at);
        return abs(f_of(k, y)) > noise_at(k, y);
    }

    const TorusSolid<Real>& torus_;
    Vec3<Real> dir_;
    Vec3<Real> near_;  ///< the point nearest to the centre
    Real slide_;       ///< the ray's parameter at near_
    Real dd_;          ///< dir·dir
    Real along_;       ///< near·dir, 0 but for rounding
    Real ll_;          ///< near·near
    Real weight_;      ///< 4 R^2
    Real k0_;          ///< k at the parameter 0
    Real k_error_;
    Real y_error_;
    Real rounding_;  ///< bound on the rounding error of f at its roots, for this very line
};

}  // namespace lancer
