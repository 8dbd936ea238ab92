// Binds textures to primitives. Only the files that instantiate it include it.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/diagnostic.h"
#include "tracer/compile/scale.h"
#include "tracer/compile/texture_placement.h"

namespace lancer {

template <class Real>
struct ChartMaker {
    const Scene& scene;

    Chart<Real> operator()(const Sphere& s) const {
        return SphereChart<Real>{convert<Real>(s.center)};
    }
    Chart<Real> operator()(const Box& b) const {
        return BoxChart<Real>{convert<Real>(b.min), convert<Real>(b.max - b.min)};
    }
    Chart<Real> operator()(const Cylinder& c) const {
        return frustum(c.base, c.top, c.radius, c.radius);
    }
    Chart<Real> operator()(const Cone& c) const {
        return frustum(c.base, c.top, c.base_radius, c.top_radius);
    }
    Chart<Real> operator()(const Torus&) const { return ParameterChart{}; }
    Chart<Real> operator()(const Plane&) const { return PlanarChart{}; }
    Chart<Real> operator()(const Triangle& t) const {
        if (t.attributes == none || !scene.triangle_attributes[t.attributes].uvs)
            return PlanarChart{};
        TriangleChart<Real> chart;
        const auto& uvs = *scene.triangle_attributes[t.attributes].uvs;
        std::transform(uvs.begin(), uvs.end(), chart.uvs.begin(), [](const Vec2d& uv) {
            return Vec2<Real>(static_cast<Real>(uv.x), static_cast<Real>(uv.y));
        });
        return chart;
    }
    Chart<Real> operator()(const MeshRef& ref) const {
        const Mesh* mesh = scene.meshes[ref.mesh].get();
        if (mesh->uvs.empty()) return PlanarChart{};
        return MeshChart{mesh};
    }
    Chart<Real> operator()(const PatchRef&) const { return ParameterChart{}; }
    Chart<Real> operator()(const LatheRef&) const { return ParameterChart{}; }
    Chart<Real> operator()(const PrismRef&) const { return ParameterChart{}; }
    Chart<Real> operator()(const CompositeRef&) const { return PlanarChart{}; }  // never used

    static Chart<Real> frustum(const Vec3d& base, const Vec3d& top, double base_radius,
                               double top_radius) {
        const Vec3d along = top - base;
        const double longest = max_component(absolute(along));
        const Vec3d y = normalize(along / longest);
        // The world's x axis made perpendicular to y; its z axis if x is too near to y.
        const int aside = std::abs(y.x) > 0.9 ? 2 : 0;
        Vec3d x = -y[aside] * y;
        x[aside] += 1;
        x = normalize(x);
        FrustumChart<Real> chart;
        chart.base = convert<Real>(base);
        chart.x = convert<Real>(x);
        chart.y = convert<Real>(y);
        chart.z = convert<Real>(cross(x, y));
        chart.height = static_cast<Real>(longest * length(along / longest));
        chart.base_radius = static_cast<Real>(base_radius);
        chart.top_radius = static_cast<Real>(top_radius);
        chart.base_is_small = base_radius <= top_radius;
        return chart;
    }
};

template <class Real>
bool finite(const Affine<Real>& m) {
    return std::all_of(m.rows.begin(), m.rows.end(),
                       [](const auto& row) { return is_finite(row); }) &&
           is_finite(m.shift);
}

/// The placement of the object's texture on its primitive.
///
/// \param own    exponent: the own coordinates of a primitive with a frame are scaled by 2^own
/// \param space  index into Scene::transforms: the space of the texture; not used with uv mapping
template <class Real>
TextureBinding<Real> bind_texture(const Scene& scene, const Geometry<Real>& geometry,
                                  const Object& object, const Primitive<Real>& primitive, int own,
                                  std::uint32_t space) {
    const Texture& texture = scene.textures[scene.materials[object.material].texture];
    const auto* image = std::get_if<ImageTexture>(&texture.pattern);
    const bool by_shape = image != nullptr && image->mapping == ImageTexture::Mapping::uv;
    const Affine<double>& to_world = scene.transforms[object.transform];
    const PlacedTexture<Real> placed{by_shape ? Affine<double>{} : texture.to_object,
                                     by_shape ? to_world : scene.transforms[space],
                                     to_world,
                                     primitive,
                                     own,
                                     geometry};
    TextureBinding<Real> seat;
    if (by_shape) seat.chart = std::visit(ChartMaker<Real>{scene}, object.shape);
    seat.placement = placed.placement(extent_of(object.shape, scene));
    if (!finite(seat.placement.map) || !is_finite(seat.placement.bound) ||
        !is_finite(seat.placement.from))
        throw SceneError(object.place,
                         "this shape's texture leaves the range of the chosen precision");
    return seat;
}

}  // namespace lancer
