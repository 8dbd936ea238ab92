// The properties of each shape apart from its numbers, and the names of its numbers, in one file.
// Requirements, messages, counts, the digest of a scene and the reference pack use it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>

#include "model/scene.h"
#include "model/splines.h"

namespace lancer {

/// A description of a shape without an inside, for messages.
struct Sheet {
    std::string_view what;
    std::string_view hint;  ///< how it could get an inside
};

struct ShapeFacts {
    std::string_view name;
    /// Whether rays can enter and leave it. Nothing: this depends on the edges of the mesh, see
    /// is_body().
    std::optional<bool> inside = std::nullopt;
    Sheet sheet = {};             ///< for a shape that has no inside, or may have none
    bool mesh = false;            ///< made of triangles with an acceleration structure
    bool spline = false;          ///< patch, lathe or prism
    bool interpolates = false;    ///< has normals to interpolate
    std::uint64_t triangles = 0;  ///< how many triangles it counts as
};

/// For a composite, the name and the inside are its own; the other facts combine those of its
/// leaves.
ShapeFacts facts_of(const Scene& scene, const Shape& shape);

namespace shape_facts {

inline constexpr std::string_view capped = "use 'capped true' to close it";

inline Sheet open_mesh_sheet(Inside inside) {
    if (inside == Inside::never) return {"a mesh with 'body false'", "remove 'body false'"};
    return {"a mesh that is not closed",
            "close it: each edge must belong to two faces, and vertices that belong together must "
            "be at exactly the same place; or write 'body true' in it, but rays that meet a gap "
            "then go wrong"};
}

inline std::optional<bool> inside_by_word(Inside inside) {
    if (inside == Inside::if_closed) return std::nullopt;
    return inside == Inside::always;
}

struct FactsOf {
    const Scene& scene;

    ShapeFacts operator()(const Sphere&) const { return {.name = "sphere", .inside = true}; }
    ShapeFacts operator()(const Box&) const { return {.name = "box", .inside = true}; }
    ShapeFacts operator()(const Cylinder& cylinder) const {
        return {.name = "cylinder",
                .inside = cylinder.capped,
                .sheet = {"a cylinder without caps", capped}};
    }
    ShapeFacts operator()(const Cone& cone) const {
        return {.name = "cone", .inside = cone.capped, .sheet = {"a cone without caps", capped}};
    }
    ShapeFacts operator()(const Torus&) const { return {.name = "torus", .inside = true}; }
    ShapeFacts operator()(const Plane&) const { return {.name = "plane", .inside = true}; }
    ShapeFacts operator()(const Triangle& t) const {
        return {.name = "triangle",
                .inside = false,
                .sheet = {"a triangle", "a closed mesh of triangles has an inside"},
                .interpolates = t.attributes != none &&
                                scene.triangle_attributes[t.attributes].normals.has_value(),
                .triangles = 1};
    }
    ShapeFacts operator()(const MeshRef& ref) const {
        return {.name = "mesh",
                .inside = inside_by_word(ref.inside),
                .sheet = open_mesh_sheet(ref.inside),
                .mesh = true,
                .interpolates = ref.smooth,
                .triangles = scene.meshes[ref.mesh]->faces.size()};
    }
    ShapeFacts operator()(const PatchRef&) const {
        return {.name = "patch",
                .inside = false,
                .sheet = {"a patch", "a lathe, a prism and a closed mesh have an inside"},
                .spline = true,
                .interpolates = true};
    }
    ShapeFacts operator()(const LatheRef& ref) const {
        const Lathe& lathe = scene.lathes[ref.lathe];
        return {
            .name = "lathe",
            .inside = encloses_space(profile_curve(lathe.spline, lathe.profile)),
            .sheet =
                {"a lathe with an open profile",
                 "close it: the profile must start and end on the axis, or end where it starts"},
            .spline = true};
    }
    ShapeFacts operator()(const PrismRef& ref) const {
        return {.name = "prism",
                .inside = scene.prisms[ref.prism].capped,
                .sheet = {"a prism without caps", capped},
                .spline = true};
    }
    ShapeFacts operator()(const CompositeRef& ref) const {
        ShapeFacts all{.name = "composite", .inside = true};
        for (const Composite::Leaf& leaf : scene.composites[ref.composite].leaves) {
            const ShapeFacts facts = facts_of(scene, leaf.object.shape);
            all.mesh = all.mesh || facts.mesh;
            all.spline = all.spline || facts.spline;
            all.interpolates = all.interpolates || facts.interpolates;
            all.triangles += facts.triangles;
        }
        return all;
    }
};

}  // namespace shape_facts

inline ShapeFacts facts_of(const Scene& scene, const Shape& shape) {
    return std::visit(shape_facts::FactsOf{scene}, shape);
}

template <class T, class Variant>
inline constexpr bool is_alternative = false;
template <class T, class... Kinds>
inline constexpr bool is_alternative<T, std::variant<Kinds...>> = (std::is_same_v<T, Kinds> || ...);
/// One of the structs of model/shapes.h.
template <class T>
concept OneShape = is_alternative<T, Shape>;

// fields(shape, take) calls take(name, value) for each field, in the order of the struct, for code
// that treats all shapes alike. The structured bindings name all fields, so a new one cannot be
// forgotten.

template <class Take>
void fields(const Sphere& s, Take&& take) {
    const auto& [center, radius] = s;
    take("center", center);
    take("radius", radius);
}
template <class Take>
void fields(const Box& s, Take&& take) {
    const auto& [min, max] = s;
    take("min", min);
    take("max", max);
}
template <class Take>
void fields(const Cylinder& s, Take&& take) {
    const auto& [base, top, radius, capped] = s;
    take("base", base);
    take("top", top);
    take("radius", radius);
    take("capped", capped);
}
template <class Take>
void fields(const Cone& s, Take&& take) {
    const auto& [base, top, base_radius, top_radius, capped] = s;
    take("base", base);
    take("top", top);
    take("base_radius", base_radius);
    take("top_radius", top_radius);
    take("capped", capped);
}
template <class Take>
void fields(const Torus& s, Take&& take) {
    const auto& [radius, tube] = s;
    take("radius", radius);
    take("tube", tube);
}
template <class Take>
void fields(const Plane& s, Take&& take) {
    const auto& [normal, offset] = s;
    take("normal", normal);
    take("offset", offset);
}
template <class Take>
void fields(const Triangle& s, Take&& take) {
    const auto& [points, attributes] = s;
    take("points", points);
    take("attributes", attributes);
}
template <class Take>
void fields(const MeshRef& s, Take&& take) {
    const auto& [mesh, smooth, inside] = s;
    take("mesh", mesh);
    take("smooth", smooth);
    take("inside", inside);
}
template <class Take>
void fields(const PatchRef& s, Take&& take) {
    const auto& [patch] = s;
    take("patch", patch);
}
template <class Take>
void fields(const LatheRef& s, Take&& take) {
    const auto& [lathe] = s;
    take("lathe", lathe);
}
template <class Take>
void fields(const PrismRef& s, Take&& take) {
    const auto& [prism] = s;
    take("prism", prism);
}
template <class Take>
void fields(const CompositeRef& s, Take&& take) {
    const auto& [composite] = s;
    take("composite", composite);
}

}  // namespace lancer
