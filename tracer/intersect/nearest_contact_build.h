// The search for the nearest contact.
#pragma once

#include "tracer/intersect/candidates.h"
#include "tracer/intersect/nearest_contact.h"

namespace lancer {

/// The planes that may be the nearest.
///
/// Estimates decide which planes come first, before any exact crossing is computed. In a room,
/// three walls lie ahead, and most rays meet an object before them. A plane whose crossing is sure
/// to count limits how far the contact can lie.
template <class Real>
class NearestPlanes {
  public:
    /// Nothing beyond it belongs to the contact.
    Real limit() const { return limit_; }

    /// Tests all planes. If eight are waiting, and one more must wait, the exact crossings of the
    /// eight are computed at once.
    ///
    /// \param sees    sees(primitive): whether the query sees it
    /// \param report  report(primitive, crossing)
    template <class Bodies, class Last, class Sees, class Report>
    [[gnu::always_inline]] void find(const Geometry<Real>& geometry, const Ray<Real>& ray,
                                     const Start<Real>& start,
                                     const IntersectionFilter<Real, Bodies>& accept,
                                     const RayInterval<Real, Last>& interval, const Sees& sees,
                                     const Report& report) {
        const auto end = static_cast<std::uint32_t>(geometry.primitives.size());
        for (std::uint32_t i = geometry.planes; i < end; ++i) {
            const PlaneGuess<Real> guess(plane_of(geometry, i), ray);
            if (guess.low > limit_ || guess.high < interval.first || guess.slope == 0) continue;
            const bool touched = accept.starts_on(i);
            if (!sees(i) || (touched && start.fresh)) continue;  // a line meets a plane once
            if (guess.high < limit_ && guess.low > start.t && !touched &&
                accept.lets_pass(i, guess.slope < 0))
                limit_ = guess.high;
            if (count_ == waiting_.size()) form_now(geometry, ray, interval, report);
            waiting_[count_++] = {i, guess.slope, guess.low};
        }
    }

    /// Whether any planes are waiting for form().
    bool wait() const { return count_ != 0; }

    /// Computes the exact crossings of the waiting planes that the interval still contains.
    template <class Last, class Report>
    [[gnu::always_inline]] void form(const Geometry<Real>& geometry, const Ray<Real>& ray,
                                     const RayInterval<Real, Last>& interval,
                                     const Report& report) {
        for (std::size_t k = 0; k < count_; ++k) {
            const Waiting& w = waiting_[k];
            if (interval.ends_before(w.low)) continue;
            const auto report_it = [&](const Crossing<Real>& c) { report(w.primitive, c); };
            crossing(plane_of(geometry, w.primitive), ray, w.slope, interval, report_it);
        }
        count_ = 0;
    }

  private:
    template <class Last, class Report>
    [[gnu::noinline]] void form_now(const Geometry<Real>& geometry, const Ray<Real>& ray,
                                    const RayInterval<Real, Last>& interval, const Report& report) {
        form(geometry, ray, interval, report);
    }

    struct Waiting {
        std::uint32_t primitive;
        Real slope;
        Real low;
    };
    std::array<Waiting, 8> waiting_;
    std::size_t count_ = 0;
    Real limit_ = std::numeric_limits<Real>::infinity();
};

template <class Real, class Bodies>
Contact<Real> nearest_contact(const Geometry<Real>& geometry, const Ray<Real>& ray,
                              const Start<Real>& start, const Bodies& bodies, Shadows shadows) {
    using std::abs;
    const IntersectionFilter<Real, Bodies> accept(geometry, start, bodies);
    Contact<Real> contact;
    NearestContact<Real> found(contact);
    NearestPlanes<Real> planes;
    const auto limit = [&] { return found.limit(); };
    // Rounding may put the exit of a body that the ray is in just before the start.
    const Real first = start.t - abs(start.t) * gamma<Real>(32);
    const RayInterval<Real, decltype(limit)> interval{first, limit};
    const auto sees = [&](std::uint32_t index) {
        return index != start.left &&
               (shadows == Shadows::ignore || geometry.primitives[index].casts_shadow);
    };
    const auto report_plane = [&](std::uint32_t index, const Crossing<Real>& c) {
        if (accept(index, c)) found.add({accept.met_at(c), c.error, {index, c.face, c.entering}});
    };
    planes.find(geometry, ray, start, accept, interval, sees, report_plane);
    found.expect(planes.limit());
    candidates_from(geometry, ray, accept, interval, [&](std::uint32_t index) {
        if (!sees(index)) return false;
        crossings_from(
            geometry, index, ray, accept, accept.hints(index), interval,
            [&](const Crossing<Real>& c, Real u, Real v) {
                if (accept(index, c))
                    found.add({accept.met_at(c), c.error, {index, c.face, c.entering}, u, v});
                return false;
            });
        return false;
    });
    if (planes.wait()) planes.form(geometry, ray, interval, report_plane);
    found.settle();
    return contact;
}

}  // namespace lancer
