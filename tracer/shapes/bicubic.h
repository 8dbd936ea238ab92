// Patches whose true surfaces rays meet, piece by piece.
#pragma once

#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include "model/shapes.h"
#include "tracer/bvh/traverse.h"
#include "tracer/rays/crossing.h"
#include "tracer/rays/shear.h"
#include "tracer/rays/surface_point.h"
#include "tracer/shapes/traits.h"
#include "tracer/splines/piece_frame.h"

namespace lancer {

/// A patch or net that is cut into pieces, with a tree over them.
template <class Real>
struct PieceTree {
    /// One Bezier patch.
    struct Home {
        Vec3<Real> anchor;              ///< a control point of the patch
        Real size;                      ///< bound on each coordinate of `points`
        splines::Bicubic<Real> points;  ///< relative to `anchor`
        Real column, row;               ///< place of the patch in its net
    };
    std::vector<Home> homes;
    std::vector<splines::Piece<Real>> pieces;
    std::vector<splines::PieceFrame<Real>> frames;  ///< one per piece
    std::vector<std::uint32_t> home;                ///< per piece an index into `homes`
    Real columns = 1, rows = 1;                     ///< size of the net
    Bvh<Real> bvh;
};

template <class Real>
PieceTree<Real> make_piece_tree(const Patch& patch, int exponent);

/// A patch or net of the scene. It is cut into pieces when the first ray comes near it. The result
/// does not depend on which ray that is.
template <class Real>
class BicubicSurface {
  public:
    /// \param exponent  its points are those of the patch times 2^exponent
    BicubicSurface(Patch patch, int exponent);

    /// Safe from many threads: one builds, the others wait.
    const PieceTree<Real>& tree() const {
        const PieceTree<Real>* ready = ready_.load(std::memory_order_acquire);
        return ready != nullptr ? *ready : build();
    }
    const PieceTree<Real>* built() const { return ready_.load(std::memory_order_acquire); }
    /// The bounds of the control points, and so of the surface.
    const Bounds<Real>& bounds() const { return bounds_; }

  private:
    const PieceTree<Real>& build() const;

    Patch patch_;
    int exponent_;
    Bounds<Real> bounds_;
    mutable std::mutex building_;
    mutable std::unique_ptr<const PieceTree<Real>> tree_;
    mutable std::atomic<const PieceTree<Real>*> ready_{nullptr};
};

/// One instance of a patch. Its faces are the pieces.
template <class Real>
struct BicubicSolid {
    const BicubicSurface<Real>* surface;

    static constexpr SolidTraits traits{.convex = false, .face_by_face = false};
    /// The measure in its own space that must not be too small; infinite if there is none.
    Real size() const { return std::numeric_limits<Real>::infinity(); }
};

/// The ray's start relative to a piece's anchor, and `noise`: a bound on how far rounding displaces
/// the piece's points as seen along the ray. Each level of cuts rounded the points 3 times; the
/// start and the shear are rounded once or twice each.
template <class Real>
struct PieceStart {
    Vec3<Real> at;
    Real noise;

    PieceStart(const Vec3<Real>& at_, Real noise_) : at(at_), noise(noise_) {}
    PieceStart(const typename PieceTree<Real>::Home& home, const Ray<Real>& ray)
        : at(start_from(ray, home.anchor)),
          noise(gamma<Real>(32) * home.size + gamma<Real>(8) * max_component(absolute(at)) +
                2 * ray.origin_error) {}
};

/// The crossings with one piece. Projected along the ray, the piece is a map of (u, v) to a plane.
/// The zeros of the map are the crossings. The coordinate along the ray then gives t.
template <class Real>
class PieceSight {
  public:
    /// \param index  of the piece
    PieceSight(const splines::Piece<Real>& piece, std::uint32_t index,
               const PieceStart<Real>& start, const Shear<Real>& shear)
        : piece_(piece), index_(index), start_(start), shear_(shear) {
        const Shear<Real>& s = shear;
        const auto& along = axis(s.z);
        const Real x0 = start.at[s.x] - s.sx * start.at[s.z];
        const Real y0 = start.at[s.y] - s.sy * start.at[s.z];
        for (std::size_t i = 0; i < 16; ++i) {
            net_[i] = {(axis(s.x)[i] - s.sx * along[i]) - x0,
                       (axis(s.y)[i] - s.sy * along[i]) - y0};
        }
    }

    /// Calls report(Crossing, u, v).
    template <class Report>
    void search(Report&& report) const {
        search(net_, 0, 0, 1, 1, report);
    }
    /// The same for a part of the square, where the map's coefficients are `net`.
    template <class Report>
    void search(const splines::PlaneNet<Real>& net, Real u, Real v, Real du, Real dv,
                Report&& report) const {
        const auto found = [&](const splines::PlaneZero<Real>& zero) {
            report(crossing(zero), zero.u, zero.v);
        };
        splines::PlaneZeros<Real, decltype(found)>(start_.noise, found).search(net, u, v, du, dv);
    }

  private:
    const std::array<Real, 16>& axis(int k) const { return piece_.c[static_cast<std::size_t>(k)]; }

    Crossing<Real> crossing(const splines::PlaneZero<Real>& zero) const {
        using std::abs;
        const splines::CubicBasis<Real> bu(zero.u);
        const splines::CubicBasis<Real> bv(zero.v);
        const splines::BicubicValue<Real> z(axis(shear_.z), bu, bv);
        const splines::PlaneValue<Real> across(net_, bu, bv);
        Crossing<Real> c;
        c.t = (z.value - start_.at[shear_.z]) * shear_.sz;
        c.error =
            abs(shear_.sz) * (start_.noise + abs(z.du) * zero.slack_u + abs(z.dv) * zero.slack_v) +
            gamma<Real>(3) * abs(c.t);
        c.face = index_;
        c.entering = across.du[0] * across.dv[1] - across.dv[0] * across.du[1] > 0;
        return c;
    }

    const splines::Piece<Real>& piece_;
    const std::uint32_t index_;
    const PieceStart<Real>& start_;
    const Shear<Real>& shear_;
    splines::PlaneNet<Real> net_;
};

template <class Real, class Report>
void piece_crossings(const splines::Piece<Real>& piece, std::uint32_t index,
                     const PieceStart<Real>& start, const Shear<Real>& shear, Report&& report) {
    PieceSight<Real>(piece, index, start, shear).search(report);
}

/// The result of a filter that computes no exact crossing.
enum class Foreseen { nothing, no_crossing, enough };

/// `no_crossing`: the line misses the piece, or meets it outside of the interval; or it starts on
/// the piece, and then has no other crossing, because it meets the piece at most once. `enough`:
/// the line certainly meets the piece, and the query needs nothing else. `nothing`: the filter does
/// not decide.
template <class Real, class Last>
Foreseen foresee(const PieceTree<Real>& tree, std::uint32_t index, const Ray<Real>& ray,
                 const PieceStart<Real>& start, const IntersectionHints& hints,
                 const RayInterval<Real, Last>& interval) {
    const splines::PieceView<Real> view(tree.frames[index], start.at, ray.dir, start.noise);
    if (!view.is_clear) return Foreseen::nothing;
    if (view.passes_by() || hints.start_face == index) return Foreseen::no_crossing;
    const auto [first, last] = view.stretch();
    if (interval.ends_before(first) || last < interval.first) return Foreseen::no_crossing;
    if constexpr (RayInterval<Real, Last>::may_accept_estimates) {
        if (view.meets(tree.pieces[index]) && interval.accepts_estimate(first, last))
            return Foreseen::enough;
    }
    return Foreseen::nothing;
}

template <class Real, class Last, class Report>
void crossings(const BicubicSolid<Real>& solid, const Ray<Real>& ray,
               const IntersectionHints& hints, const RayInterval<Real, Last>& interval,
               Report&& report) {
    const PieceTree<Real>& tree = solid.surface->tree();
    std::optional<Shear<Real>> shear;  // most rays do not need it
    const auto piece = [&](std::uint32_t index) {
        const PieceStart<Real> start(tree.homes[tree.home[index]], ray);
        const Foreseen known = foresee(tree, index, ray, start, hints, interval);
        bool stop = known == Foreseen::enough;
        if (known != Foreseen::nothing) return stop;
        if (!shear) shear = shear_of(ray);
        piece_crossings(
            tree.pieces[index], index, start, *shear,
            [&](const Crossing<Real>& c, Real u, Real v) { stop = stop || report(c, u, v); });
        return stop;
    };
    traverse(tree.bvh, ray, interval.first, interval.last,
             [&](std::uint32_t first, std::uint32_t count) {
                 for (std::uint32_t i = first; i < first + count; ++i)
                     if (piece(tree.bvh.order[i])) return true;
                 return false;
             });
}

/// The point at (u, v) of a piece.
template <class Real>
SurfacePoint<Real> bicubic_point(const BicubicSolid<Real>& solid, std::uint32_t index, Real u,
                                 Real v) {
    const PieceTree<Real>& tree = solid.surface->tree();
    const splines::Piece<Real>& piece = tree.pieces[index];
    const auto& home = tree.homes[tree.home[index]];
    const splines::CubicBasis<Real> bu(u);
    const splines::CubicBasis<Real> bv(v);
    SurfacePoint<Real> p;
    Vec3<Real> du(0);
    Vec3<Real> dv(0);
    for (int k = 0; k < 3; ++k) {
        const splines::BicubicValue<Real> at(piece.c[static_cast<std::size_t>(k)], bu, bv);
        p.offset[k] = at.value;
        du[k] = at.du;
        dv[k] = at.dv;
    }
    p.anchor = home.anchor;
    p.error = gamma<Real>(32) * home.size;
    const Vec2<Real> place(piece.u0 + piece.du * u, piece.v0 + piece.dv * v);
    p.normal = cross(du, dv);
    if (!(length_squared(p.normal) >
          gamma<Real>(64) * length_squared(du) * length_squared(dv) * gamma<Real>(64)))
        p.normal = splines::normal(home.points, place.x, place.y);
    if (p.normal == Vec3<Real>(0)) p.normal = Vec3<Real>(0, 1, 0);
    p.shading = p.normal;
    p.parameter =
        Vec2<Real>((home.column + place.x) / tree.columns, (home.row + place.y) / tree.rows);
    return p;
}

}  // namespace lancer
