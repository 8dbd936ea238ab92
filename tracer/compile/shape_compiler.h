// Compiles shapes of the scene to solids of the tracer: scaled, and in world space where that loses
// nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "model/diagnostic.h"
#include "model/patch_net.h"
#include "model/splines.h"
#include "tracer/compile/maps.h"
#include "tracer/compile/scale.h"
#include "tracer/rays/frame.h"
#include "tracer/scene/geometry.h"
#include "tracer/scene/povray_rules.h"
#include "tracer/tessellation/tessellate.h"

namespace lancer {

/// The message for a shape whose numbers leave the range of the number type beside the scene's.
inline constexpr const char* out_of_range =
    "this shape is too large or too small, compared with the rest of the scene, for the chosen "
    "precision";

/// Makes the tracer's solids, and the frames of those that stay in their own spaces.
///
/// A similarity (rotation, mirror, uniform scale, shift) is baked into a sphere, cylinder or cone.
/// Any map is baked into a plane or triangle. A map of axes to axes is baked into a box. In all
/// other cases the shape keeps its own space and gets a frame.
template <class Real>
class ShapeCompiler {
  public:
    /// \param by_povray  POV-Ray's rules, by which patches are then drawn; may be null
    ShapeCompiler(const Scene& scene, const Settings& settings, const PovRayRules* by_povray,
                  Geometry<Real>& geometry)
        : scene_(scene),
          settings_(settings),
          by_povray_(by_povray),
          geometry_(geometry),
          tessellated_(settings.tolerance || std::ranges::any_of(scene.patches, [](const Patch& p) {
                           return p.tolerance.has_value();
                       })) {
        if (tessellated_) collect_borders();
    }

    /// \param mesh  the compiled mesh, for a MeshRef
    Primitive<Real> make(const Object& object, const TriangleMesh<Real>* mesh) {
        const Affine<double>& m = scene_.transforms[object.transform];
        const int own = own_exponent(object, mesh);
        const Affine<Real> map = scaled_map(m, own);
        Primitive<Real> p;
        object_ = &object;
        std::visit([&](const auto& shape) { p.solid = solid(shape, own, map, mesh, p); },
                   object.shape);
        return p;
    }

    /// The exponent `own`: the shape's own coordinates are scaled by 2^own.
    ///
    /// \param mesh  the compiled mesh, for a MeshRef
    int own_exponent(const Object& object, const TriangleMesh<Real>* mesh) const {
        if (mesh != nullptr) return mesh->exponent;
        const bool identity = scene_.transforms[object.transform] == Affine<double>{};
        return identity && !std::holds_alternative<PatchRef>(object.shape)
                   ? geometry_.scale_exponent
                   : exponent_for(extent_of(object.shape, scene_));
    }

  private:
    /// The map from the shape's scaled space to the world's.
    Affine<Real> scaled_map(const Affine<double>& m, int own) const {
        Affine<double> in_world;
        for (std::size_t i = 0; i < 3; ++i)
            in_world.rows[i] = scaled(m.rows[i], geometry_.scale_exponent - own);
        in_world.shift = scaled(m.shift, geometry_.scale_exponent);
        in_world.shift_error = std::ldexp(m.shift_error, geometry_.scale_exponent);
        return convert<Real>(in_world);
    }

    void add_frame(const Affine<Real>& map, Primitive<Real>& p) {
        const Frame<Real> frame = make_frame(map);
        using std::sqrt;
        // Squares of mapped directions must stay in the number type's range.
        const Real least = 16 * sqrt(std::numeric_limits<Real>::min());
        if (!(frame.norm > least && frame.inverse_norm * least < 1))
            throw SceneError(object_->place, out_of_range);
        p.frame = static_cast<std::uint32_t>(geometry_.frames.size());
        geometry_.frames.push_back(frame);
    }

    static Vec3<Real> point(const Vec3d& p, int own) { return convert<Real>(scaled(p, own)); }
    static Real number(double x, int own) { return static_cast<Real>(ldexp(x, own)); }

    Solid<Real> solid(const Sphere& s, int own, const Affine<Real>& map, const TriangleMesh<Real>*,
                      Primitive<Real>& p) {
        BallSolid<Real> ball{point(s.center, own), number(s.radius, own), Real(0)};
        if (is_identity(map)) return ball;
        if (const Real factor = similarity(map); factor > 0)
            return BallSolid<Real>{map_point(map, ball.center), ball.radius * factor,
                                   moved_by(map, {ball.center}) + resized_by(map, ball.radius)};
        add_frame(map, p);
        return ball;
    }

    Solid<Real> solid(const Box& b, int own, const Affine<Real>& map, const TriangleMesh<Real>*,
                      Primitive<Real>& p) {
        BoxSolid<Real> box{point(b.min, own), point(b.max, own), Real(0)};
        if (is_identity(map)) return box;
        // A map of axes to axes has one number in each row and column.
        BoxSolid<Real> moved = box;
        moved.transform_error = moved_by(map, {box.min, box.max});
        bool along_axes = true;
        for (int i = 0; i < 3; ++i) {
            const Vec3<Real>& row = map.rows[static_cast<std::size_t>(i)];
            int from = -1;
            for (int j = 0; j < 3; ++j) {
                if (row[j] == 0) continue;
                if (from >= 0) along_axes = false;
                from = j;
            }
            if (from < 0) along_axes = false;
            if (!along_axes) break;
            const Real a = row[from] * box.min[from] + map.shift[i];
            const Real b_end = row[from] * box.max[from] + map.shift[i];
            moved.min[i] = a < b_end ? a : b_end;
            moved.max[i] = a < b_end ? b_end : a;
        }
        if (along_axes) return moved;
        add_frame(map, p);
        return box;
    }

    Solid<Real> frustum(const Vec3d& base, const Vec3d& top, double base_radius, double top_radius,
                        bool capped, int own, const Affine<Real>& map, Primitive<Real>& p) {
        const bool base_is_small = base_radius <= top_radius;
        Vec3<Real> small = point(base_is_small ? base : top, own);
        Vec3<Real> large = point(base_is_small ? top : base, own);
        Real small_radius = number(base_is_small ? base_radius : top_radius, own);
        Real large_radius = number(base_is_small ? top_radius : base_radius, own);
        Real transform_error = 0;
        if (!is_identity(map)) {
            if (const Real factor = similarity(map); factor > 0) {
                transform_error = moved_by(map, {small, large}) + resized_by(map, large_radius);
                small = map_point(map, small);
                large = map_point(map, large);
                small_radius *= factor;
                large_radius *= factor;
            } else {
                add_frame(map, p);
            }
        }
        FrustumSolid<Real> f;
        f.transform_error = transform_error;
        f.small_end = small;
        f.large_end = large;
        f.filter_error = f.transform_error + filter_error_of(small);
        const Vec3<Real> along = large - small;
        const Real longest = max_component(absolute(along));
        const Vec3<Real> short_axis = along / longest;
        f.height = longest * length(short_axis);
        f.axis = normalize(short_axis);
        f.radius = small_radius;
        f.slope = (large_radius - small_radius) / f.height;
        f.capped = capped;
        f.tilted = (along.x != 0) + (along.y != 0) + (along.z != 0) != 1;
        return f;
    }

    Solid<Real> solid(const Cylinder& c, int own, const Affine<Real>& map,
                      const TriangleMesh<Real>*, Primitive<Real>& p) {
        return frustum(c.base, c.top, c.radius, c.radius, c.capped, own, map, p);
    }
    Solid<Real> solid(const Cone& c, int own, const Affine<Real>& map, const TriangleMesh<Real>*,
                      Primitive<Real>& p) {
        return frustum(c.base, c.top, c.base_radius, c.top_radius, c.capped, own, map, p);
    }

    Solid<Real> solid(const Torus& t, int own, const Affine<Real>& map, const TriangleMesh<Real>*,
                      Primitive<Real>& p) {
        if (!is_identity(map)) add_frame(map, p);
        const int to_one = exponent_for(t.radius);
        return TorusSolid<Real>{number(t.radius, to_one), number(t.tube, to_one),
                                ldexp(Real(1), to_one - own), ldexp(Real(1), own - to_one)};
    }

    Solid<Real> solid(const Plane& plane, int own, const Affine<Real>& map,
                      const TriangleMesh<Real>*, Primitive<Real>&) {
        const Vec3<Real> n =
            normalize(convert<Real>(plane.normal / max_component(absolute(plane.normal))));
        const Vec3<Real> on = n * number(plane.offset, own);
        if (is_identity(map)) return HalfSpace<Real>{n, on, Real(0)};
        // After a shift or a scale by a power of two the normal is still a unit vector.
        if (is_scale_by_two(map))
            return HalfSpace<Real>{n, map_point(map, on), moved_by(map, {on})};
        Affine<Wide<Real>> linear = convert<Wide<Real>>(map);
        linear.shift = Vec3<Wide<Real>>(0);
        const Vec3<Wide<Real>> turned = map_transposed(inverse(linear), convert<Wide<Real>>(n));
        return HalfSpace<Real>{convert<Real>(normalize(turned / max_component(absolute(turned)))),
                               map_point(map, on), moved_by(map, {on})};
    }

    Solid<Real> solid(const Triangle& t, int own, const Affine<Real>& map,
                      const TriangleMesh<Real>*, Primitive<Real>& p) {
        const bool identity = is_identity(map);
        const auto corner = [&](std::size_t i) {
            const Vec3<Real> local = point(t.points[i], own);
            return identity ? local : map_point(map, local);
        };
        if (settings_.smooth && t.attributes != none &&
            scene_.triangle_attributes[t.attributes].normals) {
            Affine<Wide<Real>> linear = convert<Wide<Real>>(map);
            linear.shift = Vec3<Wide<Real>>(0);
            const Affine<Wide<Real>> back = inverse(linear);
            std::array<Vec3<Real>, 3> normals;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3d& given = (*scene_.triangle_attributes[t.attributes].normals)[i];
                const Vec3<Wide<Real>> n = map_transposed(
                    back, convert<Wide<Real>>(given / max_component(absolute(given))));
                normals[i] = convert<Real>(normalize(n / max_component(absolute(n))));
            }
            p.corner_normals = static_cast<std::uint32_t>(geometry_.corner_normals.size());
            geometry_.corner_normals.push_back(normals);
        }
        return TriangleSheet<Real>{
            corner(0), corner(1), corner(2),
            identity ? Real(0)
                     : moved_by(map, {point(t.points[0], own), point(t.points[1], own),
                                      point(t.points[2], own)})};
    }

    Solid<Real> solid(const MeshRef& ref, int, const Affine<Real>& map,
                      const TriangleMesh<Real>* mesh, Primitive<Real>& p) {
        if (!is_identity(map)) add_frame(map, p);
        return MeshInstance<Real>{mesh, ref.smooth && settings_.smooth};
    }

    Solid<Real> solid(const PatchRef& ref, int own, const Affine<Real>& map,
                      const TriangleMesh<Real>*, Primitive<Real>& p) {
        if (by_povray_ != nullptr) return facets(ref);
        if (!is_identity(map)) add_frame(map, p);
        if (!tessellated_) return bicubic(ref, own);
        const auto tolerance = own_tolerance(*object_, ref);
        auto& surface = patches_[{ref.patch, own, tolerance}];
        if (surface == nullptr) {
            if (!splines::is_within_limit(scene_.patches[ref.patch], tolerance))
                throw SceneError(
                    object_->place,
                    "this patch would need more than 50 million triangles for its tolerance: "
                    "increase the tolerance of the patch or of the whole picture");
            geometry_.patches.push_back(std::make_unique<PatchSurface<Real>>(
                scene_.patches[ref.patch], tolerance, &geometry_.patch_borders, own,
                settings_.smooth));
            surface = geometry_.patches.back().get();
        }
        return PatchSolid<Real>{surface, settings_.smooth};
    }

    /// Collects the borders' tolerances, unless all patches have the same tolerance: their borders
    /// then have it too.
    void collect_borders() {
        std::vector<std::pair<const Patch*, std::optional<double>>> patches;
        bool alike = true;
        for (const Object& object : scene_.objects) {
            const auto* ref = std::get_if<PatchRef>(&object.shape);
            if (ref == nullptr) continue;
            patches.emplace_back(&scene_.patches[ref->patch], own_tolerance(object, *ref));
            alike = alike && patches.back().second == patches.front().second;
        }
        if (alike) return;
        for (const auto& [patch, tolerance] : patches)
            geometry_.patch_borders.add(*patch, tolerance);
    }

    Solid<Real> bicubic(const PatchRef& ref, int own) {
        auto& surface = bicubics_[{ref.patch, own}];
        if (surface == nullptr) {
            geometry_.bicubics.push_back(
                std::make_unique<BicubicSurface<Real>>(scene_.patches[ref.patch], own));
            surface = geometry_.bicubics.back().get();
        }
        return BicubicSolid<Real>{surface};
    }

    /// POV-Ray first maps the control points to the world.
    Solid<Real> facets(const PatchRef& ref) {
        const BezierNet net = bezier_net(scene_.patches[ref.patch]);
        const Affine<double>& to_world = scene_.transforms[object_->transform];
        auto surface = std::make_unique<FacetSurface<Real>>();
        surface->columns = static_cast<Real>(net.columns);
        surface->rows = static_cast<Real>(net.rows);
        surface->halvings = by_povray_->patch_halvings[ref.patch];
        for (std::size_t i = 0; i < net.rows; ++i) {
            for (std::size_t j = 0; j < net.columns; ++j) {
                typename FacetSurface<Real>::Home home;
                const BezierPatch from = net.patch(i, j);
                for (std::size_t k = 0; k < 16; ++k)
                    home.points[k] = convert<Real>(
                        scaled(map_point(to_world, from[k]), geometry_.scale_exponent));
                for (const Vec3<Real>& p : home.points)
                    surface->reach = std::max(surface->reach, max_component(absolute(p)));
                home.column = static_cast<Real>(j);
                home.row = static_cast<Real>(i);
                surface->homes.push_back(home);
            }
        }
        geometry_.facets.push_back(std::move(surface));
        return FacetSolid<Real>{geometry_.facets.back().get()};
    }

    /// The tolerance of a patch in its own space: the strictest of all that apply. The tolerance of
    /// the settings is in units of the scene's world. A patch's own tolerance must hold both in its
    /// own space and in the world, so that it holds in whichever way a user reads it.
    std::optional<double> own_tolerance(const Object& object, const PatchRef& ref) const {
        const double growth = largest_stretch(scene_.transforms[object.transform]);
        std::optional<double> tolerance;
        if (settings_.tolerance) tolerance = *settings_.tolerance / growth;
        if (const auto own = scene_.patches[ref.patch].tolerance) {
            const double strict = *own / std::max(growth, 1.0);
            tolerance = std::min(strict, tolerance.value_or(strict));
        }
        return tolerance;
    }

    Solid<Real> solid(const LatheRef& ref, int own, const Affine<Real>& map,
                      const TriangleMesh<Real>*, Primitive<Real>& p) {
        if (!is_identity(map)) add_frame(map, p);
        const Lathe& lathe = scene_.lathes[ref.lathe];
        auto surface = std::make_unique<splines::Revolution<Real>>(
            splines::make_revolution<Real>(profile_curve(lathe.spline, lathe.profile)));
        surface->curve.exponent += own;
        geometry_.revolutions.push_back(std::move(surface));
        return LatheSolid<Real>{geometry_.revolutions.back().get()};
    }

    Solid<Real> solid(const PrismRef& ref, int own, const Affine<Real>& map,
                      const TriangleMesh<Real>*, Primitive<Real>& p) {
        if (!is_identity(map)) add_frame(map, p);
        const Prism& prism = scene_.prisms[ref.prism];
        auto surface = std::make_unique<splines::Extrusion<Real>>(splines::make_extrusion<Real>(
            outline_curve(prism.spline, prism.outline), prism.bottom, prism.top, prism.capped));
        surface->curve.exponent += own;
        geometry_.extrusions.push_back(std::move(surface));
        return PrismSolid<Real>{geometry_.extrusions.back().get(), own};
    }

    /// Never used: the leaves are made one by one (composite_compiler.h).
    Solid<Real> solid(const CompositeRef&, int, const Affine<Real>&, const TriangleMesh<Real>*,
                      Primitive<Real>&) {
        return CompositeSolid<Real>{nullptr};
    }

    const Scene& scene_;
    const Settings& settings_;
    const PovRayRules* by_povray_;
    Geometry<Real>& geometry_;
    /// Patches are tessellated if the settings or any patch has a tolerance; otherwise rays meet
    /// the true surfaces. All patches are treated alike: light would leak between a triangle and
    /// the true border of its neighbour.
    bool tessellated_;
    const Object* object_ = nullptr;  ///< the object that is being made
    /// A patch that several objects use is tessellated once for each tolerance.
    std::map<std::tuple<std::uint32_t, int, std::optional<double>>, const PatchSurface<Real>*>
        patches_;
    std::map<std::pair<std::uint32_t, int>, const BicubicSurface<Real>*> bicubics_;
};

}  // namespace lancer
