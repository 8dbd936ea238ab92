// All that one ray of the camera does, as plain data: the tree of rays that make a colour.
#pragma once

#include <cstdint>
#include <vector>

#include "model/math.h"
#include "model/shapes.h"

namespace lancer {

/// Lengths and places are in the scene's units, colours are linear light. "Share" is what of a
/// light arrives, per channel. Whitted, "An Improved Illumination Model for Shaded Display", CACM
/// 23(6) 1980, calls it a tree of rays, too.
struct RayTree {
    /// Of a composite: the leaf that brings the face.
    struct Owner {
        std::uint32_t object = none;  ///< index into Scene::objects
        std::uint32_t leaf = none;    ///< index into Composite::leaves; none: no composite

        bool operator==(const Owner&) const = default;
    };

    /// What a shadow ray meets on its way.
    struct Loss {
        enum class Kind {
            blocked,  ///< an opaque surface: one of those on the way, not always the nearest
            surface,  ///< a surface that lets a share pass
            medium,   ///< absorption on a way through a body
        };
        Kind kind = Kind::blocked;
        Owner by;
        double t = 0;          ///< surface: where; medium: where the way ends. From the surface
        Color share{0, 0, 0};  ///< that this leaves
    };

    /// What a light does at a surface.
    struct Light {
        std::uint32_t light = 0;   ///< index into Scene::lights
        Vec3d direction{0, 0, 0};  ///< unit, from the surface to the light
        double distance = 0;       ///< infinite for directional lights
        double cosine = 0;         ///< of the angle between the shading normal and `direction`
        Color sent{0, 0, 0};       ///< before shadows, with fade and spot
        bool asked = false;        ///< the material answers light from that side
        Color share{0, 0, 0};      ///< that shadows leave; 0 where nothing was sent
        std::vector<Loss> losses;
        Color added{0, 0, 0};  ///< to the surface's own light
    };

    struct Surface {
        Owner of;
        std::uint32_t face = 0;
        std::uint32_t material = 0;  ///< index into Scene::materials
        Vec3d point{0, 0, 0};
        double point_error = 0;        ///< bound on the distance from the true surface
        Vec3d geometric{0, 0, 0};      ///< unit, outward
        Vec3d normal{0, 0, 0};         ///< for shading: unit, towards the viewer
        Color color{0, 0, 0};          ///< the material's, or the texture's
        Color transmittance{0, 0, 0};  ///< share of light that passes
        Color weight{0, 0, 0};         ///< of its own light in the ray tree's colour
        Color glow{0, 0, 0};           ///< ambient and emitted light
        std::vector<Light> lights;
        Color own{0, 0, 0};             ///< `glow` and what all lights add
        Color reflectance{0, 0, 0};     ///< share that is mirrored; 0: nothing
        double mirror_weight = 0;       ///< of the mirrored ray: see Ray
        std::uint32_t mirrored = none;  ///< index into `rays`; none where it is not followed
    };

    struct Hit {
        Owner of;
        std::uint32_t face = 0;
        double t = 0;
        double t_error = 0;     ///< bound on its rounding error
        bool entering = false;  ///< against the outward normal
    };

    /// All that the ray meets in one place.
    struct Contact {
        double t = 0;           ///< along the ray, from its start; the camera's from the camera
        std::vector<Hit> hits;  ///< in the order in which they are crossed
        std::vector<std::uint32_t> inside;  ///< objects around the ray behind it
        Color share{0, 0, 0};               ///< of the light from here in the ray tree's colour
        double index_ratio = 1;             ///< refractive indices before and after
        bool total = false;                 ///< total internal reflection
        std::vector<Surface> surfaces;      ///< that show; none where equal matter is glued
        std::uint32_t bent = none;          ///< index into `rays`: how the ray goes on, if bent
    };

    enum class Kind { camera, mirrored, refracted, total };
    enum class End {
        open,        ///< it goes on as another: its last contact is `bent`
        background,  ///< it meets nothing more
        opaque,      ///< nothing comes from behind its last contact
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
        Color share{0, 0, 0};   ///< background: of its light in the ray tree's colour
        double end_weight = 0;  ///< depth, weight: what was left of `weight`
    };

    std::vector<Ray> rays;  ///< rays[0] is the camera's; each stands behind the one it comes from
    Color color{0, 0, 0};
    bool is_cut = false;  ///< it was too large: the last rays are missing; `color` is whole
};

}  // namespace lancer
