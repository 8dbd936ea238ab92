// Colours that vary over a surface: chooses between the patterns and mappings of tracer/textures/.
#pragma once

#include "tracer/rays/surface_point.h"
#include "tracer/scene/world.h"

namespace lancer {

/// Interpolates the colours of a face's corners by the hit's barycentric coordinates. White without
/// such colours; the parser allows them only on meshes that have them.
template <class Real>
Vec3<Real> vertex_color(const Primitive<Real>& primitive, const SurfacePoint<Real>& hit,
                        std::uint32_t face) {
    const auto* instance = std::get_if<MeshInstance<Real>>(&primitive.solid);
    if (instance == nullptr || instance->mesh->source->colors.empty()) return Vec3<Real>(1);
    const Mesh& mesh = *instance->mesh->source;
    const Mesh::Corners& corners = mesh.faces[face];
    const Vec2<Real>& weights = hit.parameter;
    return (1 - weights.x - weights.y) * convert<Real>(mesh.colors[corners[0]]) +
           weights.x * convert<Real>(mesh.colors[corners[1]]) +
           weights.y * convert<Real>(mesh.colors[corners[2]]);
}

/// The colour of texture `texture` at a point of a textured primitive.
///
/// \param hit   in the primitive's own space
/// \param face  the number of the face, as the shape counts them
template <class Real>
TextureColor<Real> texture_color(const World<Real>& world, std::uint32_t texture,
                                 const Primitive<Real>& primitive, const SurfacePoint<Real>& hit,
                                 std::uint32_t face) {
    const TextureBinding<Real>& seat = world.texture_bindings[primitive.texture_binding];
    const PatternPoint<Real> p = place(seat.placement, hit);
    return std::visit(
        [&](const auto& pattern) -> TextureColor<Real> {
            using P = std::decay_t<decltype(pattern)>;
            if constexpr (std::is_same_v<P, VertexPattern>) {
                return {vertex_color(primitive, hit, face)};
            } else if constexpr (std::is_same_v<P, ImagePattern<Real>>) {
                using Mapping = ImageTexture::Mapping;
                switch (pattern.mapping) {
                    case Mapping::planar:
                        return color_at(pattern, planar(p));
                    case Mapping::spherical:
                        return color_at(pattern, spherical(p));
                    case Mapping::cylindrical:
                        return color_at(pattern, cylindrical(p));
                    case Mapping::uv:
                        break;
                }
                const ChartPoint<Real> on_shape{p, map_vector(seat.placement.map, hit.normal), face,
                                                hit};
                const ImagePoint<Real> uv = std::visit(
                    [&](const auto& chart) { return uv_at(chart, on_shape); }, seat.chart);
                const Placement<Real> undo{pattern.from_uv};
                SurfacePoint<Real> flat{};
                flat.anchor = Vec3<Real>(uv.u, uv.v, 0);
                PatternPoint<Real> moved = place(undo, flat);
                moved.bound += map_bound(undo.map, Vec3<Real>(uv.u_bound, uv.v_bound, 0));
                return color_at(pattern, planar(moved));
            } else {
                return {color_at(pattern, p)};
            }
        },
        world.textures[texture]);
}

}  // namespace lancer
