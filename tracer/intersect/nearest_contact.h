// The nearest contact of a ray. (For shadow rays: shading/shadow.h.)
#pragma once

#include "tracer/bvh/traverse.h"
#include "tracer/intersect/composite_crossings.h"
#include "tracer/intersect/contact.h"
#include "tracer/intersect/intersection_filter.h"
#include "tracer/intersect/shape_crossings.h"
#include "tracer/rays/crossing.h"

namespace lancer {

/// Reports the crossings of the ray with a solid in the solid's own space.
template <class Real, class Last, class Report>
void solid_crossings(const Solid<Real>& solid, const Ray<Real>& ray, IntersectionHints hints,
                     const RayInterval<Real, Last>& interval, Report& report) {
    std::visit(
        [&](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, CompositeSolid<Real>>)
                CompositeWalk<Real>(*shape.tree, ray, {}).tell(interval, report);
            else
                shape_crossings(shape, ray, hints, interval, report);
        },
        solid);
}

/// Reports the crossings of the world ray with one primitive: report(Crossing, u, v), which returns
/// true to stop.
template <class Real, class Last, class Report>
void primitive_crossings(const World<Real>& world, const Primitive<Real>& primitive,
                         const Ray<Real>& world_ray, IntersectionHints hints,
                         const RayInterval<Real, Last>& interval, Report&& report) {
    if (primitive.frame == none)
        solid_crossings(primitive.solid, world_ray, hints, interval, report);
    else
        solid_crossings(primitive.solid, to_local(world_ray, world.frames[primitive.frame]), hints,
                        interval, report);
}

/// The same for a ray with a start, which a composite needs.
///
/// \param hints  those of `accept`, or modified ones
template <class Real, class Bodies, class Last, class Report>
void crossings_from(const World<Real>& world, std::uint32_t index, const Ray<Real>& ray,
                    const IntersectionFilter<Real, Bodies>& accept, IntersectionHints hints,
                    const RayInterval<Real, Last>& interval, Report&& report) {
    const Primitive<Real>& primitive = world.primitives[index];
    if (const CompositeTree<Real>* tree = primitive.composite()) {
        const CompositeStart<Real> known{&accept.start(), index, accept.state_of(index)};
        CompositeWalk<Real>(*tree, ray, known).tell(interval, report);
    } else {
        primitive_crossings(world, primitive, ray, hints, interval, report);
    }
}

/// The plane of a primitive in primitives[planes..].
template <class Real>
const HalfSpace<Real>& plane_of(const World<Real>& world, std::uint32_t primitive) {
    return *std::get_if<HalfSpace<Real>>(&world.primitives[primitive].solid);
}

/// Visits every primitive, except for planes, that the ray may meet on the interval: visit(index)
/// returns true to stop.
template <class Real, class Last, class Visit>
void candidates(const World<Real>& world, const Ray<Real>& ray,
                const RayInterval<Real, Last>& interval, Visit&& visit) {
    for (std::uint32_t i = world.bounded; i < world.planes; ++i) {
        if (visit(i)) return;
    }
    traverse(world.bvh, ray, interval.first, interval.last,
             [&](std::uint32_t first, std::uint32_t count) {
                 for (std::uint32_t i = first; i < first + count; ++i) {
                     if (visit(i)) return true;
                 }
                 return false;
             });
}

/// The same for a ray with a start: bodies whose boxes might hide them are visited first. The
/// search would come to nearly all of them, for a ray in a body is in its box.
template <class Real, class Bodies, class Last, class Visit>
void candidates_from(const World<Real>& world, const Ray<Real>& ray,
                     const IntersectionFilter<Real, Bodies>& accept,
                     const RayInterval<Real, Last>& interval, Visit&& visit) {
    if constexpr (std::is_same_v<Bodies, NoMedia>) {
        candidates(world, ray, interval, visit);
    } else {
        const MediaList first = accept.in_beyond_boxes();
        for (const std::uint32_t index : first) {
            if (visit(index)) return;
        }
        candidates(world, ray, interval,
                   [&](std::uint32_t index) { return !contains(first, index) && visit(index); });
    }
}

/// Which objects a query sees: all, or those that cast shadows.
enum class Shadows { ignore, cast };

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
    [[gnu::always_inline]] void find(const World<Real>& world, const Ray<Real>& ray,
                                     const Start<Real>& start,
                                     const IntersectionFilter<Real, Bodies>& accept,
                                     const RayInterval<Real, Last>& interval, const Sees& sees,
                                     const Report& report) {
        const auto end = static_cast<std::uint32_t>(world.primitives.size());
        for (std::uint32_t i = world.planes; i < end; ++i) {
            const PlaneGuess<Real> guess(plane_of(world, i), ray);
            if (guess.low > limit_ || guess.high < interval.first || guess.slope == 0) continue;
            const bool touched = accept.starts_on(i);
            if (!sees(i) || (touched && start.fresh)) continue;  // a line meets a plane once
            if (guess.high < limit_ && guess.low > start.t && !touched &&
                accept.lets_pass(i, guess.slope < 0))
                limit_ = guess.high;
            if (count_ == waiting_.size()) form_now(world, ray, interval, report);
            waiting_[count_++] = {i, guess.slope, guess.low};
        }
    }

    /// Whether any planes are waiting for form().
    bool wait() const { return count_ != 0; }

    /// Computes the exact crossings of the waiting planes that the interval still contains.
    template <class Last, class Report>
    [[gnu::always_inline]] void form(const World<Real>& world, const Ray<Real>& ray,
                                     const RayInterval<Real, Last>& interval,
                                     const Report& report) {
        for (std::size_t k = 0; k < count_; ++k) {
            const Waiting& w = waiting_[k];
            if (interval.ends_before(w.low)) continue;
            const auto report_it = [&](const Crossing<Real>& c) { report(w.primitive, c); };
            crossing(plane_of(world, w.primitive), ray, w.slope, interval, report_it);
        }
        count_ = 0;
    }

  private:
    template <class Last, class Report>
    [[gnu::noinline]] void form_now(const World<Real>& world, const Ray<Real>& ray,
                                    const RayInterval<Real, Last>& interval, const Report& report) {
        form(world, ray, interval, report);
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

/// The nearest contact, with the nearest hit in front. Empty if the ray leaves the scene.
template <class Real, class Bodies>
Contact<Real> nearest_contact(const World<Real>& world, const Ray<Real>& ray,
                              const Start<Real>& start, const Bodies& bodies,
                              Shadows shadows = Shadows::ignore) {
    using std::abs;
    const IntersectionFilter<Real, Bodies> accept(world, start, bodies);
    Contact<Real> contact;
    NearestContact<Real> found(contact);
    NearestPlanes<Real> planes;
    const auto limit = [&] { return found.limit(); };
    // Rounding may put the exit of a body that the ray is in just before the start.
    const Real first = start.t - abs(start.t) * gamma<Real>(32);
    const RayInterval<Real, decltype(limit)> interval{first, limit};
    const auto sees = [&](std::uint32_t index) {
        return index != start.left &&
               (shadows == Shadows::ignore || world.primitives[index].casts_shadow);
    };
    const auto report_plane = [&](std::uint32_t index, const Crossing<Real>& c) {
        if (accept(index, c)) found.add({accept.met_at(c), c.error, {index, c.face, c.entering}});
    };
    planes.find(world, ray, start, accept, interval, sees, report_plane);
    found.expect(planes.limit());
    candidates_from(world, ray, accept, interval, [&](std::uint32_t index) {
        if (!sees(index)) return false;
        crossings_from(
            world, index, ray, accept, accept.hints(index), interval,
            [&](const Crossing<Real>& c, Real u, Real v) {
                if (accept(index, c))
                    found.add({accept.met_at(c), c.error, {index, c.face, c.entering}, u, v});
                return false;
            });
        return false;
    });
    if (planes.wait()) planes.form(world, ray, interval, report_plane);
    found.settle();
    return contact;
}

}  // namespace lancer
