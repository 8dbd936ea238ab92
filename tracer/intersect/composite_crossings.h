// The crossings of a ray with a composite: where the state of the whole changes.
#pragma once

#include <optional>

#include "tracer/intersect/composite_events.h"
#include "tracer/intersect/face_planes.h"

namespace lancer {

/// What is known of a ray and a composite before their crossings are computed.
template <class Real>
struct CompositeStart {
    const Start<Real>* start = nullptr;  ///< null: unknown; all crossings of the line are reported
    std::uint32_t primitive = none;      ///< the composite's number, as in `start`
    std::optional<bool> inside{};  ///< whether the ray's list of bodies contains it, if listed
};

/// The crossings of one ray with one composite.
///
/// Crossings of leaves whose error bounds overlap happen at once, like a contact of several
/// objects, unless their faces are parallel and certainly apart (face_planes.h). The crossings
/// beyond a point decide whether a leaf contains the point. So the walk goes from the far end of
/// the line back to the start.
template <class Real>
class CompositeWalk {
  public:
    CompositeWalk(const CompositeTree<Real>& tree, const Ray<Real>& ray,
                  const CompositeStart<Real>& known)
        : tree_(tree),
          ray_(ray),
          known_(known),
          fresh_(known.start != nullptr && known.start->fresh),
          search_(tree, ray, first_of(known), fresh_ ? &known.start->surfaces : nullptr,
                  known.primitive),
          state_(tree) {
        search_.find(events_, state_);
        std::sort(events_.begin(), events_.end(), before);
        std::size_t ahead = 0;
        if (fresh_) ahead = put_first([&](const Event& e) { return !is_ahead(e); });
        make_contacts(ahead);
        go_back();
        if (fresh_) cross_start(ahead);
    }

    /// Whether the ray is inside the whole just beyond its start.
    bool starts_inside() const { return at_start_; }

    /// Reports the crossings: report(Crossing, u, v) returns true to stop.
    template <class Last, class Report>
    void tell(const RayInterval<Real, Last>& interval, Report&& report) const {
        bool inside = known_.inside.value_or(expected_);
        std::size_t next = 0;
        if (known_.start != nullptr && inside != at_start_) {
            if (next < changes_.size() && is_at_once(changes_[next])) {
                ++next;  // rounding cannot tell it from the start, so it counts as passed
            } else {
                if (at_once_ && tell_at_start(*at_once_, interval, report)) return;
                inside = at_start_;
            }
        }
        for (; next < changes_.size(); ++next) {
            if (changes_[next].entering == inside) continue;
            inside = changes_[next].entering;
            if (interval.ends_before(changes_[next].t)) return;
            if (tell_of(changes_[next], interval, report)) return;
        }
    }

  private:
    using Event = CompositeEvent<Real>;

    /// A contact at which the ray enters or leaves the whole.
    struct Change {
        Real t, error;
        std::size_t shown;  ///< index of the event whose face shows; `no_event`: the start's face
        std::size_t begin, end;  ///< range of the contact's events
        bool entering;
    };
    struct Range {
        std::size_t begin, end;
    };
    static constexpr std::size_t no_event = ~std::size_t{0};

    static Real first_of(const CompositeStart<Real>& known) {
        using std::abs;
        if (known.start == nullptr || !known.start->fresh)
            return -std::numeric_limits<Real>::infinity();
        return known.start->t - abs(known.start->t) * gamma<Real>(32);
    }
    static bool before(const Event& a, const Event& b) {
        if (a.t != b.t) return a.t < b.t;
        if (a.leaf != b.leaf) return a.leaf < b.leaf;
        return a.face < b.face;
    }
    bool is_ahead(const Event& e) const { return e.t - known_.start->t > e.error; }

    /// Moves the wanted events to the front, and keeps the order of both parts. Returns the number
    /// of wanted events.
    template <class Wanted>
    std::size_t put_first(const Wanted& wanted) {
        const auto begin = events_.begin();
        const auto end = std::is_partitioned(begin, events_.end(), wanted)
                             ? std::partition_point(begin, events_.end(), wanted)
                             : std::stable_partition(begin, events_.end(), wanted);
        return static_cast<std::size_t>(end - begin);
    }

    /// Groups the events from `begin` on into contacts: the next event, and all events whose error
    /// bounds overlap its own.
    void make_contacts(std::size_t begin) {
        Real widest = 0;
        for (std::size_t i = begin; i < events_.size(); ++i)
            widest = std::max(widest, events_[i].error);
        while (begin < events_.size()) {
            const Event anchor = events_[begin];
            std::size_t end = begin + 1;
            for (std::size_t i = end; i < events_.size(); ++i) {
                const Real apart = events_[i].t - anchor.t;
                if (apart > anchor.error + widest) break;
                if (apart > anchor.error + events_[i].error) continue;
                const auto at = [&](std::size_t k) {
                    return events_.begin() + static_cast<std::ptrdiff_t>(k);
                };
                std::rotate(at(end), at(i), at(i + 1));
                ++end;
            }
            add_contact({begin, end});
            begin = end;
        }
    }

    /// Adds a contact, or several where all its faces are parallel and lie apart: then their planes
    /// tell the order of the crossings, however thin what is between them.
    void add_contact(const Range& range) {
        const std::optional<int> axis = common_axis(range);
        if (!axis) return contacts_.push_back(range);
        const bool up = ray_.dir[*axis] > 0;
        const auto begin = events_.begin() + static_cast<std::ptrdiff_t>(range.begin);
        const auto end = events_.begin() + static_cast<std::ptrdiff_t>(range.end);
        std::sort(begin, end, [&](const Event& a, const Event& b) {
            const Real at_a = plane_of(a)->at;
            const Real at_b = plane_of(b)->at;
            return at_a != at_b ? (at_a < at_b) == up : before(a, b);
        });
        for (std::size_t i = range.begin; i < range.end;) {
            std::size_t next = i + 1;
            while (next < range.end && plane_of(events_[next])->at == plane_of(events_[i])->at)
                ++next;
            contacts_.push_back({i, next});
            i = next;
        }
    }

    std::optional<FacePlane<Real>> plane_of(const Event& e) const {
        return plane_of_face(tree_.leaves[e.leaf].primitive, e.face);
    }

    /// The axis that all faces of a contact of several events are perpendicular to, if there is
    /// one.
    std::optional<int> common_axis(const Range& range) const {
        if (range.end - range.begin < 2) return std::nullopt;
        std::optional<int> axis;
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const std::optional<FacePlane<Real>> plane = plane_of(events_[i]);
            if (!plane || plane->axis != axis.value_or(plane->axis)) return std::nullopt;
            axis = plane->axis;
        }
        return axis;
    }

    /// Undoes a contact. Returns the change of the whole, if there is one.
    std::optional<Change> undo(const Range& contact) {
        const bool after = state_.holds();
        const auto begin = events_.begin() + static_cast<std::ptrdiff_t>(contact.begin);
        const auto end = events_.begin() + static_cast<std::ptrdiff_t>(contact.end);
        std::sort(begin, end, [](const Event& a, const Event& b) {
            return a.leaf != b.leaf ? a.leaf < b.leaf : before(a, b);
        });
        state_.begin_step();
        turned_.clear();
        for (auto e = begin; e != end;) {
            const std::uint32_t leaf = e->leaf;
            // Entries through two faces that meet at an edge count as one; so do exits.
            std::size_t in = no_event;
            std::size_t out = no_event;
            for (; e != end && e->leaf == leaf; ++e) {
                std::size_t& way = e->entering ? in : out;
                if (way == no_event) way = static_cast<std::size_t>(e - events_.begin());
            }
            if ((in == no_event) == (out == no_event)) continue;
            const std::uint32_t depth = state_.depth(leaf);
            const bool enters = in != no_event;
            state_.set_depth(leaf, enters ? depth - (depth > 0 ? 1 : 0) : depth + 1);
            if (enters ? depth == 1 : depth == 0) turned_.push_back(enters ? in : out);
        }
        if (state_.holds() == after) return std::nullopt;
        for (const std::size_t i : turned_) {
            if (state_.changed_the_whole(events_[i].leaf))
                return Change{events_[i].t, events_[i].error, i, contact.begin, contact.end, after};
        }
        return std::nullopt;
    }

    /// Goes from the far end back to the start, and fills changes_, the nearest first.
    void go_back() {
        std::size_t passed = 0;  // contacts behind the ray's start
        if (known_.start != nullptr && !fresh_) {
            while (passed < contacts_.size() && !is_ahead(events_[contacts_[passed].begin]))
                ++passed;
        }
        for (std::size_t i = contacts_.size(); i-- > passed;) {
            if (const auto change = undo(contacts_[i])) changes_.push_back(*change);
        }
        std::reverse(changes_.begin(), changes_.end());
        at_start_ = state_.holds();
        expected_ = at_start_;
        if (fresh_) return;
        while (passed-- > 0 && !at_once_) at_once_ = undo(contacts_[passed]);
        if (known_.start == nullptr) return;
        if (at_once_ && known_.start->t - at_once_->t <= at_once_->error) expected_ = !at_start_;
    }

    /// Undoes the contact at or before the start, and sets at_once_: the change to report if the
    /// list of bodies puts the ray on the wrong side.
    void cross_start(std::size_t end) {
        const bool own = !search_.started().empty();
        if (own) {
            // A ray that starts on a face is on the side of it that it goes to.
            const std::uint32_t leaf = search_.started().front().leaf;
            expected_ = (state_.depth(leaf) > 0) != tree_.leaves[leaf].subtracted;
        }
        std::size_t begin = 0;
        while (begin < end && known_.start->t - events_[begin].t > events_[begin].error) ++begin;
        at_once_ = begin < end ? undo({begin, end}) : std::nullopt;
        if (!at_once_ && own) {
            at_once_ = Change{known_.start->t, Real(0), no_event, 0, 0, at_start_};
            turning_ = turning_face();
        }
        if (at_once_ && !own && !known_.inside) expected_ = !at_start_;
    }

    /// Which of the faces that the ray starts on leads to the state that the whole is in: but for
    /// what its leaf does, the whole would be in the other one.
    std::size_t turning_face() {
        const auto& started = search_.started();
        for (std::size_t i = 0; i < started.size(); ++i) {
            const std::uint32_t depth = state_.depth(started[i].leaf);
            state_.set_depth(started[i].leaf, depth > 0 ? 0 : 1);
            const bool turns = state_.holds() != at_start_;
            state_.set_depth(started[i].leaf, depth);
            if (turns) return i;
        }
        return 0;
    }

    /// Whether the distance between start and contact is below the rounding error.
    bool is_at_once(const Change& change) const {
        const Real reach = 4 * ray_.origin_error + 8 * change.error +
                           gamma<Real>(16) * max_component(absolute(ray_.origin));
        return change.t - known_.start->t <= reach;
    }

    /// The face of the whole that an event, or a start, is on.
    std::uint32_t face_of(const auto& at) const {
        return tree_.leaves[at.leaf].first_face + at.face;
    }

    template <class Last, class Report>
    bool tell_face(const Change& change, const RayInterval<Real, Last>& interval, Report& report,
                   std::uint32_t face, Real u = 0, Real v = 0) const {
        const Crossing<Real> c{change.t, change.error, face, change.entering};
        return interval.holds(c) && report(c, u, v);
    }

    template <class Last, class Report>
    bool tell_of(const Change& change, const RayInterval<Real, Last>& interval,
                 Report& report) const {
        const Event& shown = events_[change.shown];
        if (tell_face(change, interval, report, face_of(shown), shown.u, shown.v)) return true;
        if (known_.start == nullptr) return false;
        for (std::size_t i = change.begin; i < change.end; ++i) {
            const Event& e = events_[i];
            if (i == change.shown) continue;
            if (tell_face(change, interval, report, face_of(e) | hidden_face, e.u, e.v))
                return true;
        }
        return false;
    }

    /// Tells of the change that brought the ray to where it is. It counts as at the start, though
    /// it may lie before it by more than its own error: contacts are as wide as their widest error,
    /// and the start is a crossing of one of them alone. All faces that the ray starts on are still
    /// the contact's.
    template <class Last, class Report>
    bool tell_at_start(Change change, const RayInterval<Real, Last>& interval,
                       Report& report) const {
        change.t = std::max(change.t, known_.start->t);
        const bool by_event = change.shown != no_event;
        if (by_event && tell_of(change, interval, report)) return true;
        const auto tell_started = [&](std::size_t i, std::uint32_t hidden) {
            return tell_face(change, interval, report, face_of(search_.started()[i]) | hidden);
        };
        if (!by_event && tell_started(turning_, 0)) return true;
        for (std::size_t i = 0; i < search_.started().size(); ++i) {
            if (!by_event && i == turning_) continue;
            if (tell_started(i, hidden_face)) return true;
        }
        return false;
    }

    const CompositeTree<Real>& tree_;
    const Ray<Real>& ray_;
    const CompositeStart<Real>& known_;
    const bool fresh_;
    const CompositeSearch<Real> search_;
    CompositeState<Real> state_;
    CompositeEvents<Real> events_;
    boost::container::small_vector<Range, 16> contacts_;
    boost::container::small_vector<Change, 16> changes_;
    boost::container::small_vector<std::size_t, 8> turned_;
    std::optional<Change> at_once_;  ///< how the ray comes to be where it is
    std::size_t turning_ = 0;        ///< in search_.started(): the face of a change without event
    bool at_start_ = false;
    bool expected_ = false;  ///< whether it is taken to be inside, where no list tells
};

}  // namespace lancer
