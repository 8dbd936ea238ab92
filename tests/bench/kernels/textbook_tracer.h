// The code between the shapes in its textbook form: plain slab tests, starts rounded to one number,
// the nearest hit beyond an epsilon.
#pragma once

#include "tests/bench/kernels/textbook_shapes.h"
#include "tracer/intersect/searches_build.h"
#include "tracer/rays/crossing.h"
#include "tracer/shading/shadow.h"

namespace lancer {

// Kay, Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986: without widening.

template <methods::Tree Real, class Numbers>
Numbers widened_far(const Numbers& far) {
    return far;
}

// Tests one plane after the other: a textbook's crossing costs no more than a filter.

template <methods::Shapes Real>
class NearestPlanes<Real> {
  public:
    Real limit() const { return std::numeric_limits<Real>::infinity(); }
    template <class Bodies, class Last, class Sees, class Report>
    [[gnu::always_inline]] void find(const Geometry<Real>& geometry, const Ray<Real>& ray,
                                     const Start<Real>&,
                                     const IntersectionFilter<Real, Bodies>& accept,
                                     const RayInterval<Real, Last>& interval, const Sees& sees,
                                     const Report& report) {
        const auto end = static_cast<std::uint32_t>(geometry.primitives.size());
        for (std::uint32_t i = geometry.bounded; i < end; ++i) {
            if (sees(i))
                crossings(plane_of(geometry, i), ray, accept.hints(i), interval,
                          [&](const Crossing<Real>& c) { report(i, c); });
        }
    }
    bool wait() const { return false; }
    template <class Last, class Report>
    void form(const Geometry<Real>&, const Ray<Real>&, const RayInterval<Real, Last>&,
              const Report&) {}
};

template <methods::Shapes Real, class Bodies, class Last, class Sees, class Report>
[[gnu::always_inline]] inline void planes_on_the_way(const Geometry<Real>& geometry,
                                                     const Ray<Real>& ray,
                                                     const IntersectionFilter<Real, Bodies>& accept,
                                                     const RayInterval<Real, Last>& interval,
                                                     const Sees& is_seen, const Report& report) {
    const auto end = static_cast<std::uint32_t>(geometry.primitives.size());
    for (std::uint32_t i = geometry.bounded; i < end; ++i) {
        if (is_seen(i)) crossings(plane_of(geometry, i), ray, accept.hints(i), interval, report);
        if (interval.last.query.occlusion == Occlusion::blocked) return;
    }
}

template <methods::Contacts Real, class Bodies>
class IntersectionFilter<Real, Bodies> {
  public:
    IntersectionFilter(const Geometry<Real>&, const Start<Real>& start, const Bodies&)
        : start_(start), nearest_(start.t + textbook_epsilon) {}
    IntersectionHints hints(std::uint32_t) const { return {}; }
    bool operator()(std::uint32_t, const Crossing<Real>& c) const { return c.t > nearest_; }
    Real met_at(const Crossing<Real>& c) const { return c.t; }
    bool starts_on(std::uint32_t) const { return false; }
    bool lets_pass(std::uint32_t, bool) const { return true; }
    MediaList in_beyond_boxes() const { return {}; }
    // Only composites need this, and the bench has none.
    const Start<Real>& start() const { return start_; }
    std::optional<bool> state_of(std::uint32_t) const { return std::nullopt; }

  private:
    const Start<Real>& start_;
    Real nearest_;
};

template <methods::Contacts Real>
class NearestContact<Real> {
  public:
    explicit NearestContact(Contact<Real>& contact) : contact_(contact) {}
    Real limit() const { return nearest_.t; }
    void expect(Real) {}
    void add(const Hit<Real>& hit) {
        if (hit.t < nearest_.t) nearest_ = hit;
    }
    void settle() {
        if (nearest_.t < std::numeric_limits<Real>::infinity()) contact_.push_back(nearest_);
    }

  private:
    Contact<Real>& contact_;
    Hit<Real> nearest_{std::numeric_limits<Real>::infinity(), 0, {}};
};

}  // namespace lancer
