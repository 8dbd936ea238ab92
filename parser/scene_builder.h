// Puts the Scene together: groups, inherited materials, transforms composed and rounded once.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/scene.h"
#include "parser/meter.h"
#include "parser/transforms.h"

namespace lancer {

/// What every shape and group takes.
struct Attributes {
    std::uint32_t material = none;
    std::string name;
    bool shadow = true;
    TransformList transforms;
};

class SceneBuilder {
  public:
    SceneBuilder(Meter& meter, Report& report) : meter_(meter), report_(report) {}

    Scene scene;
    /// Where the scene holds what files brought.
    std::map<std::pair<std::string, bool>, std::uint32_t> image_indices;  ///< path, sRGB
    std::unordered_map<const Mesh*, std::uint32_t> mesh_indices;

    /// Objects and lights from here to close_group() are in a new group. What the group itself
    /// says is known only at its end.
    void open_group(const SourceSpan& place);
    void close_group(const Attributes& attributes);

    void add(const Shape& shape, const Attributes& attributes, const SourceSpan& place);
    void add(const Light& light);
    std::uint32_t add(const Material& material, std::string_view name, const SourceSpan& place);
    std::uint32_t add(const Texture& texture, const SourceSpan& place);
    void add(const Camera& camera);

  private:
    /// A transform and defaults that act on what refers to it, within the transforms of its parent.
    struct Node {
        Transform map;
        std::uint32_t parent = none;
        std::uint32_t material = none;
        std::uint32_t name = none;
        bool shadow = true;
        bool moves = false;
        std::uint32_t transform = none;  ///< in the scene, once it is known
    };

    void resolve();
    std::uint32_t name_index(const std::string& name);
    std::uint32_t transform_index(const Transform& exact, const SourceSpan& place);
    void count(std::size_t made, const SourceSpan& place, const char* what);

    Meter& meter_;
    Report& report_;
    std::unordered_map<std::string, std::uint32_t> names_;
    std::vector<Node> nodes_;            ///< of the outermost open group; parents come first
    std::vector<std::uint32_t> groups_;  ///< open ones, as nodes
    std::vector<std::uint32_t> light_nodes_;
    std::size_t first_object_ = 0;  ///< of the outermost open group
    std::size_t first_light_ = 0;
};

}  // namespace lancer
