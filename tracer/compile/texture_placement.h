// Where a texture lies on a primitive. It is computed from places in the world, not from the shifts
// of inverse maps: a move that changes no digit of the places changes none of the texture.
#pragma once

#include <cmath>

#include "model/affine.h"
#include "tracer/scene/geometry.h"

namespace lancer {

/// A bound on how far rounding moved a solid when it was baked into the world; 0 for those that
/// keep a space of their own.
template <class Real>
struct TransformError {
    Real operator()(const BallSolid<Real>& s) const { return s.transform_error; }
    Real operator()(const BoxSolid<Real>& s) const { return s.transform_error; }
    Real operator()(const FrustumSolid<Real>& s) const { return s.transform_error; }
    Real operator()(const HalfSpace<Real>& s) const { return s.transform_error; }
    Real operator()(const TriangleSheet<Real>& s) const { return s.transform_error; }
    Real operator()(const TorusSolid<Real>&) const { return 0; }
    Real operator()(const MeshInstance<Real>&) const { return 0; }
    Real operator()(const PatchSolid<Real>&) const { return 0; }
    Real operator()(const BicubicSolid<Real>&) const { return 0; }
    Real operator()(const FacetSolid<Real>&) const { return 0; }
    Real operator()(const LatheSolid<Real>&) const { return 0; }
    Real operator()(const PrismSolid<Real>&) const { return 0; }
    Real operator()(const CompositeSolid<Real>&) const { return 0; }
};

/// A texture on a primitive. A primitive's points are in the scaled world, or in the primitive's
/// own scaled space where it has a frame.
template <class Real>
class PlacedTexture {
    using Map = Affine<long double>;
    using Vector = Vec3<long double>;

  public:
    /// \param texture   from the texture's space to the space `home`
    /// \param home      from there to the world; mostly the object's own space
    /// \param to_world  from the object's own space
    /// \param own       exponent: coordinates in a frame are scaled by 2^own
    PlacedTexture(const Affine<double>& texture, const Affine<double>& home,
                  const Affine<double>& to_world, const Primitive<Real>& primitive, int own,
                  const Geometry<Real>& geometry)
        : reference_(rounding_of(home, texture.shift) == 0 ? convert<long double>(texture.shift)
                                                           : Vector(0)),
          texture_(convert<long double>(texture)),
          home_(convert<long double>(home)),
          to_world_(convert<long double>(to_world)),
          primitive_(primitive),
          unit_(std::ldexp(1.0L, primitive.frame == none ? geometry.scale_exponent : own)),
          is_in_world_(primitive.frame == none),
          is_at_home_(home == to_world) {}

    /// \param extent  of the object's shape, in its own space
    Placement<Real> placement(double extent) const {
        const Vector from = place_of_reference();
        const Map to_texture = map();
        Placement<Real> placement;
        placement.from = convert<Real>(from);
        Map rounded = to_texture;
        rounded.shift = map_point(inverse(texture_), reference_) +
                        map_vector(to_texture, convert<long double>(placement.from) - from);
        placement.map = convert<Real>(rounded);
        placement.bound = convert<Real>(bound(to_texture, extent));
        return placement;
    }

  private:
    /// From the primitive's points to the texture's space; only the linear part counts.
    Map map() const {
        Map to_home = compose(is_in_world_ ? inverse(home_) : Map{}, scale(1 / unit_));
        if (!is_in_world_ && !is_at_home_)
            to_home = compose(inverse(home_), compose(to_world_, scale(1 / unit_)));
        return compose(inverse(texture_), to_home);
    }

    /// Among the primitive's points.
    Vector place_of_reference() const {
        if (!is_in_world_ && is_at_home_) return reference_ * unit_;
        const Vector in_world = map_point(home_, reference_);
        if (is_in_world_) return in_world * unit_;
        return map_vector(inverse(to_world_), in_world - to_world_.shift) * unit_;
    }

    /// How far rounding may have moved the primitive and the texture, in the texture's space.
    Vector bound(const Map& to_texture, double extent) const {
        Vector moved(0);     // among the primitive's points
        Vector computed(0);  // sizes that have a few roundings
        const Vector placed = map_bound(home_, absolute(texture_.shift));
        if (is_in_world_) {
            const Real error = std::visit(TransformError<Real>{}, primitive_.solid);
            moved += Vector(static_cast<long double>(error) + unit_ * error_of_texture());
            computed += unit_ * placed;
            if (!(to_world_ == Map{})) computed += unit_ * map_bound(to_world_, Vector(extent));
        } else if (is_at_home_) {
            moved += Vector(unit_ * texture_.shift_error);
            computed += unit_ * absolute(texture_.shift);
        } else {
            const Map back = inverse(to_world_);
            moved += unit_ * map_bound(back, Vector(error_of_texture() + to_world_.shift_error));
            computed += absolute(place_of_reference()) + unit_ * map_bound(back, placed);
        }
        constexpr auto roundings = static_cast<long double>(gamma<Real>(8));
        return map_bound(to_texture, moved + roundings * computed);
    }

    /// In the world: how far rounding moved the texture, beside what moved its home and the object
    /// alike.
    long double error_of_texture() const {
        return max_component(map_bound(home_, Vector(texture_.shift_error))) +
               (is_at_home_ ? 0 : home_.shift_error);
    }

    static Map scale(long double factor) {
        Map map;
        for (Vector& row : map.rows) row *= factor;
        return map;
    }

    /// In the space `home`: the point from which points are counted. The texture's origin, if its
    /// place in the world is not rounded; else the origin of `home`.
    Vector reference_;
    Map texture_, home_, to_world_;
    const Primitive<Real>& primitive_;
    long double unit_;  ///< of the primitive's points, in the units of its space
    bool is_in_world_;
    bool is_at_home_;  ///< the texture is laid out in the object's own space
};

}  // namespace lancer
