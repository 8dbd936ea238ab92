// Puts the Scene together: groups, inherited materials, transforms composed and rounded once.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "model/bodies.h"
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

/// A shape, and the material that comes with it; `none`: that of what it is a part of.
struct Part {
    Shape shape;
    std::uint32_t material = none;
};
/// What is put into the scene for a shape that may bring materials along. `has_material`: it or a
/// group around it was given one.
using MakeParts = std::function<std::vector<Part>(bool has_material)>;

class SceneBuilder {
  public:
    SceneBuilder(Meter& meter, Report& report) : meter_(meter), report_(report) {}

    Scene scene;
    /// Where the scene holds what files brought.
    std::map<std::pair<std::string, bool>, std::uint32_t> image_indices;  ///< path, sRGB
    std::unordered_map<const Mesh*, std::uint32_t> mesh_indices;
    /// What a mesh becomes with its file's materials; second: smooth.
    std::map<std::tuple<const Mesh*, bool, Inside>, std::vector<Part>> mesh_parts;
    std::unordered_set<const Mesh*> pieces;  ///< those that are one material's share of another

    /// Objects and lights from here to close_group() are in a new group, or are made one body. What
    /// the group itself says is known only at its end.
    void open_group(const SourceSpan& place, std::optional<Composite::Kind> joint);
    void close_group(const Attributes& attributes);

    void add(const Shape& shape, const Attributes& attributes, const SourceSpan& place);
    /// The same for a shape whose materials count only when no other is given: `make` is called
    /// once, at the end of the outermost group at the latest. All parts get the attributes.
    void add(MakeParts make, const Attributes& attributes, const SourceSpan& place);
    void add(const Light& light);
    std::uint32_t add(const Material& material, std::string_view name, const SourceSpan& place);
    std::uint32_t add(const Texture& texture, const SourceSpan& place);
    void add(const Camera& camera);
    /// The index of the texture that is the colours of vertices; one serves all materials.
    std::uint32_t vertex_colors(const SourceSpan& place);

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
        // Of groups, and what makes bodies one:
        SourceSpan place{};
        std::optional<Composite::Kind> joint{};
        bool in_body = false;          ///< makes one body, or stands in what does
        bool holds_body = false;       ///< something to make one of
        bool of_object = false;        ///< it is no group, but the transforms of one object
        std::uint32_t whole = none;    ///< the outermost node that makes this a part of one body
        std::uint32_t space = none;    ///< where an inherited texture lies; none: with the object
        std::uint32_t in_tree = none;  ///< node of the composite, once it is made
    };

    void resolve();
    std::uint32_t transform_of(std::uint32_t node, const SourceSpan& place);
    bool is_in_body() const { return !groups_.empty() && nodes_[groups_.back()].in_body; }
    void check_part(const Shape& shape, const Attributes& attributes, const SourceSpan& place);
    void check_body(const Node& node);
    void make_composites(const std::vector<std::uint32_t>& node_of,
                         const std::vector<bool>& own_material);
    std::uint32_t tree_node(Composite& composite, std::vector<std::uint32_t>& children,
                            std::uint32_t node);
    void make_late_parts();
    std::uint32_t name_index(const std::string& name);
    std::uint32_t transform_index(const Transform& exact, const SourceSpan& place);
    void count(std::size_t made, const SourceSpan& place, const char* what);

    Meter& meter_;
    Report& report_;
    std::uint32_t vertex_colors_ = none;
    std::unordered_map<std::string, std::uint32_t> names_;
    std::vector<Node> nodes_;            ///< of the outermost open group; parents come first
    std::vector<std::uint32_t> groups_;  ///< open ones, as nodes
    std::vector<std::uint32_t> light_nodes_;
    std::size_t first_object_ = 0;  ///< of the outermost open group
    std::size_t first_light_ = 0;
    /// By the object of the outermost open group that stands for them.
    std::unordered_map<std::size_t, MakeParts> late_parts_;
    std::vector<bool> absorbed_;  ///< objects of it that went into a composite
    Bodies bodies_{scene};
};

}  // namespace lancer
