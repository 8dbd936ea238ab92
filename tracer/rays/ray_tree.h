// The ray tree of one camera ray, as plain data: all rays that contribute to a colour.
#pragma once

#include <cstdint>
#include <vector>

#include "model/math.h"
#include "model/shapes.h"

namespace lancer {

/// Lengths and points are in the scene's units, colours are linear light. A "share" is the part of
/// some light that arrives, per channel. Whitted, "An Improved Illumination Model for Shaded
/// Display", CACM 23(6) 1980, also has a tree of rays.
struct RayTree {
    /// The owner of a face: an object, and for a composite the leaf.
    struct Owner {
        std::uint32_t object = none;  ///< index into Scene::objects
        std::uint32_t leaf = none;    ///< index into Composite::leaves; none: no composite

        bool operator==(const Owner&) const = default;
    };

    /// A loss of light on a shadow ray.
    struct Loss {
        enum class Kind {
            blocked,  ///< by an opaque surface: one of those on the way, not always the nearest
            surface,  ///< by a surface that lets a share pass
            medium,   ///< by absorption in a body
        };
        Kind kind = Kind::blocked;
        Owner by;
        double t = 0;          ///< distance from the start: of the surface; medium: of its end
        Color share{0, 0, 0};  ///< the share that passes
    };

    /// The contribution of a light at a surface.
    struct Light {
        std::uint32_t light = 0;   ///< index into Scene::lights
        Vec3d direction{0, 0, 0};  ///< unit, from the surface to the light
        double distance = 0;       ///< infinite for directional lights
        double cosine = 0;         ///< of the angle between the shading normal and `direction`
        Color sent{0, 0, 0};       ///< before shadows, after fade and spot
        bool asked = false;        ///< the material reflects or transmits light from that side
        Color share{0, 0, 0};      ///< the share that arrives; 0 if nothing was sent
        std::vector<Loss> losses;
        Color added{0, 0, 0};  ///< its contribution to the surface's local light
    };

    struct Surface {
        Owner of;
        std::uint32_t face = 0;
        std::uint32_t material = 0;  ///< index into Scene::materials
        Vec3d point{0, 0, 0};
        double point_error = 0;        ///< bound on the distance from the true surface
        Vec3d geometric{0, 0, 0};      ///< unit, outward
        Vec3d normal{0, 0, 0};         ///< shading normal: unit, towards the viewer
        Color color{0, 0, 0};          ///< the material's, or the texture's
        Color transmittance{0, 0, 0};  ///< share of light that passes
        Color weight{0, 0, 0};         ///< factor of its local light in the ray tree's colour
        Color glow{0, 0, 0};           ///< ambient and emitted light
        std::vector<Light> lights;
        Color own{0, 0, 0};             ///< local light: `glow` and the contributions of all lights
        Color reflectance{0, 0, 0};     ///< share that is mirrored
        double mirror_weight = 0;       ///< Ray::weight of the mirrored ray
        std::uint32_t mirrored = none;  ///< index into `rays`; none if it is not followed
    };

    struct Hit {
        Owner of;
        std::uint32_t face = 0;
        double t = 0;
        double t_error = 0;     ///< bound on the rounding error of t
        bool entering = false;  ///< the ray goes against the outward normal
    };

    /// A contact of the ray.
    struct Contact {
        double t = 0;  ///< distance from the ray's start; for the camera ray from the camera
        std::vector<Hit> hits;              ///< in the order of order_contact()
        std::vector<std::uint32_t> inside;  ///< objects that contain the ray behind the contact
        Color share{0, 0, 0};           ///< factor of the light from here in the ray tree's colour
        double index_ratio = 1;         ///< refractive index before over index after
        bool total = false;             ///< total internal reflection
        std::vector<Surface> surfaces;  ///< the visible ones; empty where equal bodies are glued
        std::uint32_t bent = none;      ///< index into `rays`: the refracted or reflected ray
    };

    enum class Kind { camera, mirrored, refracted, total };
    enum class End {
        open,        ///< it continues as another ray: `bent` of its last contact
        background,  ///< it meets nothing more
        opaque,      ///< its last contact is opaque
        depth,       ///< Settings::max_depth
        weight,      ///< Settings::min_contribution
        surfaces,    ///< too many surfaces in a straight line
    };

    struct Ray {
        Kind kind = Kind::camera;
        Vec3d origin{0, 0, 0};
        Vec3d direction{0, 0, 0};
        std::vector<std::uint32_t> inside;  ///< objects around its start, the last one counts
        double weight = 1;  ///< largest channel of each factor on the way here, multiplied
        int depth = 0;      ///< reflections and bends so far
        std::vector<Contact> contacts;
        End end = End::open;
        Color share{0, 0, 0};   ///< background: factor of its light in the ray tree's colour
        double end_weight = 0;  ///< depth, weight: the weight of the ray that was not followed
    };

    std::vector<Ray> rays;  ///< rays[0] is the camera ray; each comes after the ray that sent it
    Color color{0, 0, 0};
    bool is_cut =
        false;  ///< the tree was too large, and the last rays are missing; `color` is right
};

}  // namespace lancer
