// The torus: a tube bent into a ring round the y axis.
#pragma once

#include <array>
#include <limits>

#include "tracer/rays/crossing.h"
#include "tracer/rays/ray.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/traits.h"
#include "tracer/splines/roots.h"
#include "tracer/textures/mapping.h"

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

/// The surface along a line, as a function whose sign tells the inside: with the ring's radius R
/// and the tube's r,
///     f = k^2 + 4 R^2 (y^2 - r^2),    k = |p|^2 - R^2 - r^2,
/// which is what the textbook's quartic (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2) comes to when its
/// terms of the size R^4 are taken out by hand (Hanrahan, "A survey of ray-surface intersection
/// algorithms", in: Glassner (ed.), An Introduction to Ray Tracing (1989), has that). What is left
/// vanishes with the tube: all terms are at most of the size (R r)^2 near the surface, so a tube of
/// a billionth of its ring keeps its digits. f is never expanded, like that of surfaces of
/// revolution (tracer/splines/revolution.h): k and y are halved, and f's coefficients formed anew.
template <class Real>
struct TorusPiece {
    splines::Bernstein<Real, 2> k;
    splines::Bernstein<Real, 1> y;
    Real tube;
    Real weight;  ///< 4 R^2
    splines::Bernstein<Real, 4> f{};
    Real largest = 0;  ///< of the terms that f is a sum of

    TorusPiece(const splines::Bernstein<Real, 2>& k_, const splines::Bernstein<Real, 1>& y_,
               Real tube_, Real weight_)
        : k(k_), y(y_), tube(tube_), weight(weight_) {
        const Real a = weight * ((y[0] - tube) * (y[0] + tube));
        const Real b = weight * (y[0] * y[1] - tube * tube);
        const Real c = weight * ((y[1] - tube) * (y[1] + tube));
        // Both parts raised to the fourth degree.
        f = {k[0] * k[0] + a, k[0] * k[1] + (a + b) / 2,
             (k[0] * k[2] + 2 * (k[1] * k[1])) / 3 + (a + 4 * b + c) / 6, k[1] * k[2] + (b + c) / 2,
             k[2] * k[2] + c};
        for (const Real x : k) largest = std::max(largest, x * x);
        for (const Real x : y) largest = std::max(largest, weight * (x * x));
        largest = std::max(largest, weight * (tube * tube));
    }
    const splines::Bernstein<Real, 4>& coefficients() const { return f; }
    /// Products, weighted means and two sums.
    Real noise() const { return 3 * gamma<Real>(6) * largest; }
    std::pair<TorusPiece, TorusPiece> split() const {
        const auto [k0, k1] = splines::halves(k);
        const auto [y0, y1] = splines::halves(y);
        return {{k0, y0, tube, weight}, {k1, y1, tube, weight}};
    }
    splines::ValueAndSlope<Real> at(Real s) const {
        const auto [vk, sk] = splines::evaluate(k, s);
        const auto [vy, sy] = splines::evaluate(y, s);
        return {vk * vk + weight * ((vy - tube) * (vy + tube)), 2 * (vk * sk + weight * (vy * sy))};
    }
};

/// A line in the torus' scale, its start slid along itself to where it is nearest to the centre.
template <class Real>
class TorusLine {
  public:
    TorusLine(const TorusSolid<Real>& torus, const Ray<Real>& ray) : torus_(torus) {
        using std::abs;
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
        place_ =
            ray.origin_error * torus.shrink + gamma<Real>(6) * ((size.x + size.y + size.z) + reach);
        // What k is off by: the line's displacement, and some roundings of its terms.
        k_error_ = place_ * (2 * reach + place_) + gamma<Real>(32) * (reach * reach);
        y_error_ = place_ + gamma<Real>(8) * reach;
    }

    /// The parameters between which the line may be inside: it is near the plane of the ring, and
    /// between two balls about the centre. f is positive at their ends, beyond all doubt: k and y
    /// are taken to where they leave the tube by more than they can be off.
    ///
    /// Returns how many intervals there are.
    int intervals(std::array<std::array<Real, 2>, 2>& found) const {
        using std::abs;
        using std::sqrt;
        const Real middle = torus_.ring * torus_.ring + torus_.tube * torus_.tube;
        const Real width = 2 * torus_.ring * torus_.tube + 8 * k_error_;
        const Real outer = (middle + width) - ll_;
        if (!(outer > 0)) return 0;
        Real high = sqrt(outer / dd_);
        Real low = -high;
        const Real half = torus_.tube + 8 * y_error_;
        // Where the line climbs by less than a rounding of the tube it is as good as level.
        const Real climb = dir_.y * high;
        if (abs(climb) > y_error_) {
            const Real a = (-half - near_.y) / dir_.y;
            const Real b = (half - near_.y) / dir_.y;
            low = std::max(low, a < b ? a : b);
            high = std::min(high, a < b ? b : a);
        } else if (!(abs(near_.y) < half)) {
            return 0;
        }
        if (!(low < high)) return 0;
        const Real inner = (middle - width) - ll_;
        const Real hole = inner > 0 ? sqrt(inner / dd_) : Real(0);
        int count = 0;
        if (!(hole > 0)) {
            found[0] = {low, high};
            return 1;
        }
        if (low < -hole) found[static_cast<std::size_t>(count++)] = {low, std::min(high, -hole)};
        if (high > hole) found[static_cast<std::size_t>(count++)] = {std::max(low, hole), high};
        return count;
    }

    TorusPiece<Real> piece(Real from, Real to) const {
        return {{k_at(from), dd_ * (from * to) + along_ * (from + to) + k0(), k_at(to)},
                {y_at(from), y_at(to)},
                torus_.tube,
                weight()};
    }

    /// The parameter of the ray.
    Real ray_parameter(Real at) const { return at + slide_; }

    /// Bounds the error of a root: on both sides of it, that far away, the sign of f is certain.
    /// Between such places the true surface is crossed; where the line but touches it, both of its
    /// roots lie there, or none.
    Real bound(Real at) const {
        using std::abs;
        using std::sqrt;
        const Real k = k_at(at);
        const Real y = y_at(at);
        const Real noise = noise_at(k, y);
        const Real slope = 2 * (k * (2 * (dd_ * at + along_)) + weight() * (y * dir_.y));
        // The second derivative is nowhere larger on the way.
        const Real reach = torus_.reach();
        const Real bend = 32 * dd_ * (reach * reach);
        const Real least = sqrt(noise * bend);
        const Real steep = abs(slope) > least ? abs(slope) : least;
        Real error = 2 * noise / steep;
        const Real most = 2 * reach / sqrt(dd_);
        while (error < most && !(is_certain(at - error) && is_certain(at + error))) error *= 2;
        return error + gamma<Real>(4) * (abs(at) + abs(slide_));
    }

  private:
    Real weight() const { return 4 * (torus_.ring * torus_.ring); }
    Real k0() const { return ll_ - torus_.ring * torus_.ring - torus_.tube * torus_.tube; }
    Real k_at(Real at) const { return (dd_ * at + 2 * along_) * at + k0(); }
    Real y_at(Real at) const { return near_.y + at * dir_.y; }
    /// What f is off by for lines as near to this one as rounding may have moved it.
    Real noise_at(Real k, Real y) const {
        using std::abs;
        return k_error_ * (2 * abs(k) + k_error_) +
               weight() * (y_error_ * (2 * abs(y) + y_error_)) +
               gamma<Real>(6) * (k * k + weight() * (y * y + torus_.tube * torus_.tube));
    }
    bool is_certain(Real at) const {
        using std::abs;
        const Real k = k_at(at);
        const Real y = y_at(at);
        const Real f = k * k + weight() * ((y - torus_.tube) * (y + torus_.tube));
        return abs(f) > noise_at(k, y);
    }

    const TorusSolid<Real>& torus_;
    Vec3<Real> dir_;
    Vec3<Real> near_;  ///< the point nearest to the centre
    Real slide_;       ///< the ray's parameter there
    Real dd_;          ///< dir·dir
    Real along_;       ///< near·dir: what rounding left of it
    Real ll_;          ///< near·near
    Real place_;       ///< bound on the line's displacement
    Real k_error_;
    Real y_error_;
};

/// Entries and exits alternate, for all lines begin and end outside.
template <class Real, class Last, class Report>
void crossings(const TorusSolid<Real>& torus, const Ray<Real>& ray, const IntersectionHints& hints,
               const RayInterval<Real, Last>& interval, Report&& report) {
    using std::abs;
    const TorusLine<Real> line(torus, ray);
    std::array<std::array<Real, 2>, 2> spans{};
    const int count = line.intervals(spans);
    std::array<Real, 8> roots;
    std::size_t found = 0;
    for (int i = 0; i < count; ++i) {
        const auto [from, to] = spans[static_cast<std::size_t>(i)];
        splines::sign_change_roots<Real>(
            line.piece(from, to), [&, from = from, to = to](const splines::Root<Real>& root) {
                if (found < roots.size()) roots[found++] = from + (to - from) * root.s;
            });
    }
    // Of a line that starts on the surface, the crossing there: the nearest to 0 of its kind.
    std::size_t start = found;
    if (hints.start_face != none) {
        for (std::size_t i = 0; i < found; ++i) {
            if ((i % 2 == 0) != hints.inside) continue;
            const Real t = abs(line.ray_parameter(roots[i]));
            if (start != found && !(t < abs(line.ray_parameter(roots[start])))) continue;
            if (t <= 4 * line.bound(roots[i])) start = i;
        }
    }
    bool leaves = false;
    for (std::size_t i = 0; i < found; ++i) {
        if (i == start) continue;
        Crossing<Real> c{line.ray_parameter(roots[i]), 0, 0, i % 2 == 0};
        leaves = leaves || (!c.entering && c.t > 0);
        if (interval.ends_before(c.t) || !hints.asks_about(c.entering)) continue;
        c.error = line.bound(roots[i]);
        leaves = leaves || (!c.entering && c.t + c.error >= 0);
        if (c.entering && i + 1 < found) c.chord = line.ray_parameter(roots[i + 1]) - c.t;
        if (interval.holds(c)) report(c);
    }
    // It is known to be inside, and so shallow that rounding denies it: it goes out where it is.
    if (hints.inside && !leaves && !interval.ends_before(Real(0))) {
        const Crossing<Real> out{0, line.bound(-line.ray_parameter(Real(0))), 0, false};
        if (interval.holds(out)) report(out);
    }
}

/// The crossing's point, put back onto the surface. Its parameters: u the angle about the axis, v
/// that about the tube, from the side that faces the axis.
template <class Real>
SurfacePoint<Real> surface_point(const TorusSolid<Real>& torus, const Ray<Real>& ray, Real t,
                                 std::uint32_t /*face*/) {
    using std::sqrt;
    const Vec3<Real> near = (start_from(ray, Vec3<Real>(0)) + t * ray.dir) * torus.shrink;
    const Real away = sqrt(near.x * near.x + near.z * near.z);
    const Real cosine = away > 0 ? near.x / away : Real(1);
    const Real sine = away > 0 ? near.z / away : Real(0);
    Real out = away - torus.ring;
    Real up = near.y;
    const Real distance = sqrt(out * out + up * up);
    out = distance > 0 ? out / distance : Real(1);
    up = distance > 0 ? up / distance : Real(0);
    SurfacePoint<Real> p;
    p.anchor = Vec3<Real>(torus.ring * cosine, 0, torus.ring * sine) * torus.grow;
    const Vec3<Real> outward(out * cosine, up, out * sine);
    p.offset = outward * (torus.tube * torus.grow);
    // Of a length that no power of two makes 1: unit() then does the same to it in the world and in
    // a space of the torus's own, where it would leave alone what is unit in only one of them.
    p.normal = outward * Real(1.5);
    p.error = gamma<Real>(8) * (torus.reach() * torus.grow);
    p.shading = p.normal;
    p.parameter = Vec2<Real>(turn(sine, cosine), turn(-up, -out));
    return p;
}

}  // namespace lancer
