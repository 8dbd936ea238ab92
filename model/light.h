// Lights, in world space: a group's transforms are already applied.
#pragma once

#include <optional>
#include <variant>

#include "model/math.h"
#include "model/source.h"

namespace lancer {

/// Multiplies the light by 2 / (1 + (d / distance)^power).
struct Fade {
    double distance = 1;  ///< > 0
    double power = 2;
};

struct PointLight {
    Vec3d position{0, 0, 0};
    std::optional<Fade> fade;
};

struct DirectionalLight {
    Vec3d direction{0, -1, 0};  ///< the way the light travels; any length but 0
};

/// Full intensity inside `radius`, decreasing smoothly to zero at `falloff`: half-angles in
/// degrees.
struct SpotLight {
    Vec3d position{0, 0, 0};
    Vec3d look_at{0, 0, 0};
    double radius = 30;
    double falloff = 45;
    double tightness = 0;
    std::optional<Fade> fade;
};

/// The closed set of lights.
using LightKind = std::variant<PointLight, DirectionalLight, SpotLight>;

struct Light {
    LightKind kind;
    Color color{1, 1, 1};
    bool shadows = true;  ///< false: a fill light without shadows and highlights
    SourceSpan place{};
};

}  // namespace lancer
