// The shapes of the scene language as plain data. tracer/shapes/ intersects rays with them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "model/math.h"

namespace lancer {

/// Marks an index that points nowhere.
inline constexpr std::uint32_t none = 0xFFFFFFFF;

/// Solid ball.
struct Sphere {
    Vec3d center{0, 0, 0};
    double radius = 1;  ///< > 0

    bool operator==(const Sphere&) const = default;
};

/// Solid box along the axes of its own space.
struct Box {
    Vec3d min{-1, -1, -1};
    Vec3d max{1, 1, 1};  ///< each component >= that of `min`

    bool operator==(const Box&) const = default;
};

/// Solid cylinder, or only its side when not capped.
struct Cylinder {
    Vec3d base{0, 0, 0};
    Vec3d top{0, 1, 0};  ///< != base
    double radius = 1;   ///< > 0
    bool capped = true;

    bool operator==(const Cylinder&) const = default;
};

/// Solid cone or truncated cone, or only its side when not capped.
struct Cone {
    Vec3d base{0, 0, 0};
    Vec3d top{0, 1, 0};      ///< != base
    double base_radius = 1;  ///< >= 0; one of the two radii > 0
    double top_radius = 0;   ///< >= 0
    bool capped = true;

    bool operator==(const Cone&) const = default;
};

/// Solid torus around the y axis of its own space, in the plane y = 0.
struct Torus {
    double radius = 1;  ///< of the circle in the middle of the tube; >= tube
    double tube = 0.5;  ///< radius of the tube, > 0

    bool operator==(const Torus&) const = default;
};

/// The points p with normal·p = offset·|normal|. Its inside is opposite to the normal.
struct Plane {
    Vec3d normal{0, 1, 0};  ///< as written: any length but 0
    double offset = 0;

    bool operator==(const Plane&) const = default;
};

/// One triangle. Normals and uvs, which few triangles have, are in `Scene::triangle_attributes`.
struct Triangle {
    std::array<Vec3d, 3> points{};
    std::uint32_t attributes = none;  ///< index into Scene::triangle_attributes

    bool operator==(const Triangle&) const = default;
};

struct TriangleAttributes {
    std::optional<std::array<Vec3d, 3>> normals;
    std::optional<std::array<Vec2d, 3>> uvs;
};

/// Whether a mesh has an inside: decided by its edges (is_closed), or declared by its author.
enum class Inside : std::uint8_t { if_closed, always, never };

/// One use of a mesh of the scene. Many may refer to the same mesh.
struct MeshRef {
    std::uint32_t mesh = 0;  ///< index into Scene::meshes
    bool smooth = true;      ///< interpolate normals
    Inside inside = Inside::if_closed;

    bool operator==(const MeshRef&) const = default;
};

/// A bicubic patch or net, index into Scene::patches.
struct PatchRef {
    std::uint32_t patch = 0;

    bool operator==(const PatchRef&) const = default;
};

/// A surface of revolution, index into Scene::lathes.
struct LatheRef {
    std::uint32_t lathe = 0;

    bool operator==(const LatheRef&) const = default;
};

/// An extruded outline, index into Scene::prisms.
struct PrismRef {
    std::uint32_t prism = 0;

    bool operator==(const PrismRef&) const = default;
};

/// A solid made of solids, index into Scene::composites.
struct CompositeRef {
    std::uint32_t composite = 0;

    bool operator==(const CompositeRef&) const = default;
};

/// The closed set of shapes. If a line is added here, the compiler names every place that does not
/// handle it.
using Shape = std::variant<Sphere, Box, Cylinder, Cone, Torus, Plane, Triangle, MeshRef, PatchRef,
                           LatheRef, PrismRef, CompositeRef>;

/// Indexed triangles. A corner has up to three indices: position, normal, texture coordinates.
struct Mesh {
    using Corners = std::array<std::uint32_t, 3>;

    std::vector<Vec3d> vertices;
    std::vector<Corners> faces;  ///< into `vertices`; at least one, none degenerate
    std::vector<Vec3d> normals;  ///< may be empty: none given
    /// Into `normals`, one per face; empty: the same as `faces`. A corner may be `none`.
    std::vector<Corners> normal_faces;
    std::vector<Vec2d> uvs;  ///< may be empty
    /// Into `uvs`, one per face; empty: the same as `faces`. A corner may be `none`.
    std::vector<Corners> uv_faces;
    std::vector<Vec3d> colors;  ///< linear light, one per vertex; may be empty: none given
};

/// Bicubic Bézier patch (4 x 4) or uniform bicubic B-spline net (rows x columns, each >= 4).
struct Patch {
    enum class Basis { bezier, bspline };
    Basis basis = Basis::bezier;
    std::uint32_t rows = 4;
    std::uint32_t columns = 4;
    std::vector<Vec3d> control;  ///< row by row
    std::optional<double> tolerance;
};

enum class Spline { linear, bezier, bspline, catmull_rom };

/// A 2D curve rotated about the y axis of its own space.
struct Lathe {
    std::vector<Vec2d> profile;  ///< (r, y); r of the curve is never negative
    Spline spline = Spline::linear;
    std::optional<double> tolerance;
};

/// A closed 2D curve extruded along y.
struct Prism {
    std::vector<Vec2d> outline;  ///< (x, z), the first point not repeated at the end
    Spline spline = Spline::linear;
    double bottom = 0;
    double top = 1;  ///< > bottom
    bool capped = true;
    std::optional<double> tolerance;
};

}  // namespace lancer
