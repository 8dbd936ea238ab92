// Builds the Scene: groups, inherited materials, transforms that are composed first and rounded
// once.
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

/// The attributes of every shape and group.
struct Attributes {
    std::uint32_t material = none;
    std::string name;
    bool shadow = true;
    TransformList transforms;
};

/// A shape, and the material that comes with it; `none`: the material of the object that it is a
/// part of.
struct Part {
    Shape shape;
    std::uint32_t material = none;
};
/// Makes the parts of a shape that may bring materials along. `has_material`: the shape or a group
/// around it was given one.
using MakeParts = std::function<std::vector<Part>(bool has_material)>;

class SceneBuilder {
  public:
    SceneBuilder(Meter& meter, Report& report) : meter_(meter), report_(report) {}

    Scene scene;
    /// The indices of loaded images and meshes in the scene.
    std::map<std::pair<std::string, bool>, std::uint32_t> image_indices;  ///< path, sRGB
    std::unordered_map<const Mesh*, std::uint32_t> mesh_indices;
    /// The parts of a mesh with the materials of its file, by mesh, smoothness and inside.
    std::map<std::tuple<const Mesh*, bool, Inside>, std::vector<Part>> mesh_parts;
    /// meshes that hold the faces of one material of another mesh
    std::unordered_set<const Mesh*> pieces;

    /// Objects and lights from here to close_group() belong to a new group, or form one body. The
    /// group's own attributes are known only at its end.
    void open_group(const SourceSpan& place, std::optional<Composite::Kind> joint);
    void close_group(const Attributes& attributes);

    void add(const Shape& shape, const Attributes& attributes, const SourceSpan& place);
    /// The same for a shape with materials that count only when no other is given. `make` is called
    /// once, at the end of the outermost group at the latest. All parts get the attributes.
    void add(MakeParts make, const Attributes& attributes, const SourceSpan& place);
    void add(const Light& light);
    std::uint32_t add(const Material& material, std::string_view name, const SourceSpan& place);
    std::uint32_t add(const Texture& texture, const SourceSpan& place);
    void add(const Camera& camera);
    /// The index of the texture that stands for vertex colours; all materials share it.
    std::uint32_t vertex_colors(const SourceSpan& place);

  private:
    /// A transform and defaults for all nodes and objects that refer to this one. The transforms of
    /// its parent apply as well.
    struct Node {
        Transform map;
        std::uint32_t parent = none;
        std::uint32_t material = none;
        std::uint32_t name = none;
        bool shadow = true;
        bool moves = false;
        std::uint32_t transform = none;  ///< in the scene, once it is known
        // For groups and composites:
        SourceSpan place{};
        std::optional<Composite::Kind> joint{};
        bool in_body = false;        ///< makes one body, or stands within a node that does
        bool holds_body = false;     ///< contains a body
        bool of_object = false;      ///< not a group: holds the transform of one object
        std::uint32_t whole = none;  ///< the outermost node that makes this a part of one body
        /// where an inherited texture is placed; none: with the object
        std::uint32_t space = none;
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
    /// By the index of the object that stands for the parts, within the outermost open group.
    std::unordered_map<std::size_t, MakeParts> late_parts_;
    std::vector<bool> absorbed_;  ///< objects of that group that went into a composite
    Bodies bodies_{scene};
};

}  // namespace lancer
