// The appearance of surfaces. docs/shading.md has the formulas, term by term.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "model/affine.h"
#include "model/math.h"
#include "model/shapes.h"

namespace lancer {

struct ImageTexture {
    enum class Mapping { planar, spherical, cylindrical, uv };
    enum class Filter { nearest, bilinear };
    enum class Wrap { repeat, once };
    std::uint32_t image = 0;  ///< index into Scene::images
    Mapping mapping = Mapping::planar;
    Filter filter = Filter::bilinear;
    Wrap wrap = Wrap::repeat;
};

struct Checker {
    Color even{1, 1, 1};
    Color odd{0, 0, 0};
};

struct Gradient {
    struct Stop {
        double at = 0;
        Color color{0, 0, 0};
    };
    Vec3d axis{0, 1, 0};      ///< any length but 0
    std::vector<Stop> stops;  ///< at least one; `at` never decreases
};

/// The colours of a mesh's vertices, interpolated over its faces: `color vertex` in a material.
/// Only meshes with colours may use it.
struct VertexColors {};

struct Texture {
    std::variant<ImageTexture, Checker, Gradient, VertexColors> pattern;
    Affine<double> to_object;  ///< the texture's own transforms
};

/// The terms add up, so this is one flat struct. The defaults are those of the language.
struct Material {
    Color color{1, 1, 1};
    std::uint32_t texture = none;  ///< index into Scene::textures; replaces `color`
    double ambient = 0.1;
    double diffuse = 0.6;
    Color emission{0, 0, 0};
    double phong = 0;
    double shininess = 40;  ///< (R·L)^shininess
    double blinn = 0;
    double roughness = 0.05;  ///< (N·H)^(1/roughness)
    double metallic = 0;
    Color reflection{0, 0, 0};
    bool fresnel = false;
    double transmission = 0;  ///< filter + transmission <= 1
    double filter = 0;
    double ior = 1;             ///< > 0
    Color absorption{0, 0, 0};  ///< per unit of length
    double diffuse_transmission = 0;
    double phong_transmission = 0;
};

}  // namespace lancer
