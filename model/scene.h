// The scene: the result of the evaluator, and the input of tracer, exporter and `info`.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/affine.h"
#include "model/image.h"
#include "model/light.h"
#include "model/material.h"
#include "model/settings.h"
#include "model/shapes.h"
#include "model/source.h"

namespace lancer {

struct PerspectiveProjection {
    double fov = 40;  ///< full vertical angle, degrees, in (0, 180)
};
struct OrthographicProjection {
    double height = 4;  ///< of the picture, scene units, > 0
};

struct Camera {
    std::string name;
    Vec3d position{0, 0, 0};
    Vec3d look_at{0, 0, -1};  ///< != position
    Vec3d up{0, 1, 0};        ///< not parallel to the view
    std::variant<PerspectiveProjection, OrthographicProjection> projection;
    SourceSpan place{};
};

/// An image that textures of the scene use, decoded once: linear light, 3 or 4 channels.
struct SceneImage {
    std::string path;
    bool decode_srgb = true;              ///< false: `color_space "linear"`
    std::shared_ptr<const Image> pixels;  ///< never null in a scene without errors
};

/// One shape in the world.
struct Object {
    Shape shape;
    std::uint32_t material = 0;   ///< index into Scene::materials; 0 is the default material
    std::uint32_t transform = 0;  ///< index into Scene::transforms; 0 is the identity
    std::uint32_t name = none;    ///< index into Scene::names
    bool casts_shadow = true;
    SourceSpan place{};  ///< of its keyword
};

/// A solid made of solids: a tree of unions, intersections and differences of bodies.
///
/// The transform of its object is the identity: each leaf has its own place in the world.
struct Composite {
    enum class Kind : std::uint8_t { unite, intersect, subtract };

    /// The position of a child, which is a node or a leaf.
    struct Place {
        std::uint32_t parent = none;  ///< index into `nodes`; `none` for the whole
        /// the first of its parent's children, from which a difference cuts the others
        bool first = false;
    };
    struct Node {
        Kind kind = Kind::unite;
        Place place;
        std::uint32_t begin = 0;  ///< its leaves: leaves[begin..end), at least one
        std::uint32_t end = 0;
    };
    struct Leaf {
        Object object;  ///< a body; its material is that of the faces that it contributes
        Place place;
        /// index into Scene::transforms: the transform of its texture
        std::uint32_t texture_space = 0;
    };

    std::vector<Node> nodes;   ///< nodes[0] is the whole; a parent comes before its children
    std::vector<Leaf> leaves;  ///< in the order of declaration
};

struct Scene {
    int width = 640;
    int height = 480;
    Settings settings;
    Color background{0, 0, 0};
    /// The sky, if there is one, replaces the background: a function of the cosine between the
    /// ray's direction and the axis; stops from -1 to 1.
    std::optional<Gradient> sky;
    Color ambient{1, 1, 1};
    std::vector<Camera> cameras;  ///< the first is the default
    std::vector<Light> lights;
    std::vector<Object> objects;  ///< in the order of declaration

    std::vector<Material> materials{Material{}};
    std::vector<Affine<double>> transforms{Affine<double>{}};  ///< object to world; none singular
    std::vector<Texture> textures;
    std::vector<SceneImage> images;
    std::vector<std::shared_ptr<const Mesh>> meshes;
    std::vector<TriangleAttributes> triangle_attributes;
    std::vector<Patch> patches;
    std::vector<Lathe> lathes;
    std::vector<Prism> prisms;
    std::vector<Composite> composites;  ///< each is shown by one object
    std::vector<std::string> names;
    std::vector<std::string> material_names;  ///< of materials[i]; may be shorter or empty
};

}  // namespace lancer
