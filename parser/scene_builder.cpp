#include "parser/scene_builder.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace lancer {
namespace {

Vec3d moved_point(const Transform& m, const Vec3d& p) {
    return convert<double>(map_point(m, convert<long double>(p)));
}

/// Applies a group's transforms to a light. False when a coordinate overflows.
struct LightMover {
    const Transform& m;

    bool operator()(PointLight& light) const {
        light.position = moved_point(m, light.position);
        return is_finite(light.position);
    }
    bool operator()(DirectionalLight& light) const {
        const auto exact = map_vector(m, convert<long double>(light.direction));
        light.direction = convert<double>(exact);
        return is_finite(light.direction) && light.direction != Vec3d(0, 0, 0);
    }
    bool operator()(SpotLight& light) const {
        light.position = moved_point(m, light.position);
        light.look_at = moved_point(m, light.look_at);
        return is_finite(light.position) && is_finite(light.look_at) &&
               light.position != light.look_at;
    }
};

}  // namespace

void SceneBuilder::count(std::size_t made, const SourceSpan& place, const char* what) {
    if (made < meter_.limits().objects) return;
    report_.error(Message::object_limit, place, meter_.limits().objects, what);
    throw StopReading{};
}

std::uint32_t SceneBuilder::name_index(const std::string& name) {
    if (name.empty()) return none;
    const auto [at, is_new] = names_.emplace(name, static_cast<std::uint32_t>(scene.names.size()));
    if (is_new) scene.names.push_back(name);
    return at->second;
}

std::uint32_t SceneBuilder::transform_index(const Transform& exact, const SourceSpan& place) {
    Affine<double> rounded;
    if (is_singular(exact) || !round_transform(exact, rounded)) {
        report_.error(Message::transform_singular, place);
        return 0;
    }
    if (rounded == scene.transforms.front()) return 0;
    Affine<double>& last = scene.transforms.back();
    if (rounded == last)
        last.shift_error = std::max(last.shift_error, rounded.shift_error);
    else
        scene.transforms.push_back(rounded);
    return static_cast<std::uint32_t>(scene.transforms.size() - 1);
}

void SceneBuilder::open_group(const SourceSpan& place, std::optional<Composite::Kind> joint) {
    if (groups_.empty()) {
        first_object_ = scene.objects.size();
        first_light_ = scene.lights.size();
    }
    count(nodes_.size(), place, "groups and moved objects within one group");
    Node node;
    node.parent = groups_.empty() ? none : groups_.back();
    node.place = place;
    node.joint = joint;
    node.in_body = joint.has_value() || is_in_body();
    groups_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    nodes_.push_back(node);
}

void SceneBuilder::close_group(const Attributes& attributes) {
    Node& node = nodes_[groups_.back()];
    node.map = attributes.transforms.map;
    node.moves = attributes.transforms.given;
    node.material = attributes.material;
    node.name = name_index(attributes.name);
    node.shadow = attributes.shadow;
    check_body(node);
    groups_.pop_back();
    if (groups_.empty()) resolve();
}

/// The outermost group is complete: computes world transforms, and children inherit attributes.
void SceneBuilder::resolve() {
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        Node& node = nodes_[i];
        const bool inherits = node.material == none && node.parent != none;
        if (node.joint) node.whole = i;
        if (node.joint) node.space = i;
        if (inherits && nodes_[node.parent].space != none) node.space = nodes_[node.parent].space;
        if (node.parent == none) continue;
        const Node& parent = nodes_[node.parent];
        if (parent.whole != none) node.whole = parent.whole;
        if (parent.moves) {
            node.map = node.moves ? compose(parent.map, node.map) : parent.map;
            node.moves = true;
        }
        if (node.material == none) node.material = parent.material;
        if (node.name == none) node.name = parent.name;
        node.shadow = node.shadow && parent.shadow;
    }
    std::vector<std::uint32_t> node_of;
    std::vector<bool> own_material;
    for (std::size_t i = first_object_; i < scene.objects.size(); ++i) {
        Object& object = scene.objects[i];
        const Node& node = nodes_[object.transform];
        node_of.push_back(object.transform);
        own_material.push_back(object.material != none);
        object.transform = transform_of(object.transform, object.place);
        if (object.material == none) object.material = node.material;
        if (object.name == none) object.name = node.name;
        object.casts_shadow = object.casts_shadow && node.shadow;
    }
    for (std::size_t i = first_light_; i < scene.lights.size(); ++i) {
        const Node& node = nodes_[light_nodes_[i - first_light_]];
        if (node.moves && !std::visit(LightMover{node.map}, scene.lights[i].kind))
            report_.error(Message::transform_singular, scene.lights[i].place);
    }
    make_composites(node_of, own_material);
    nodes_.clear();
    light_nodes_.clear();
    make_late_parts();
}

/// The index of the node's transform in the scene.
std::uint32_t SceneBuilder::transform_of(std::uint32_t index, const SourceSpan& place) {
    Node& node = nodes_[index];
    if (node.transform == none) node.transform = node.moves ? transform_index(node.map, place) : 0;
    return node.transform;
}

/// Inserts the parts of objects at their places, removes objects that went into a composite, and
/// sets the default material where none was given.
void SceneBuilder::make_late_parts() {
    const auto begin = scene.objects.begin() + static_cast<std::ptrdiff_t>(first_object_);
    if (!late_parts_.empty() || !absorbed_.empty()) {
        const std::vector<Object> wholes(begin, scene.objects.end());
        scene.objects.erase(begin, scene.objects.end());
        for (std::size_t i = 0; i < wholes.size(); ++i) {
            if (!absorbed_.empty() && absorbed_[i]) continue;
            const auto late = late_parts_.find(first_object_ + i);
            if (late == late_parts_.end()) {
                scene.objects.push_back(wholes[i]);
                continue;
            }
            for (const Part& part : late->second(wholes[i].material != none)) {
                count(scene.objects.size(), wholes[i].place, "objects");
                scene.objects.push_back(wholes[i]);
                scene.objects.back().shape = part.shape;
                if (part.material != none) scene.objects.back().material = part.material;
            }
        }
        late_parts_.clear();
        absorbed_.clear();
    }
    for (std::size_t i = first_object_; i < scene.objects.size(); ++i)
        if (scene.objects[i].material == none) scene.objects[i].material = 0;
}

void SceneBuilder::add(MakeParts make, const Attributes& attributes, const SourceSpan& place) {
    // The materials of a file split a mesh into sheets. A body needs the whole mesh.
    const bool whole = is_in_body();
    if (attributes.material == none && !groups_.empty() && !whole) {
        late_parts_.emplace(scene.objects.size(), std::move(make));
        add(Shape{}, attributes, place);
        return;
    }
    Attributes own = attributes;
    for (const Part& part : make(whole || attributes.material != none)) {
        if (part.material != none) own.material = part.material;
        add(part.shape, own, place);
    }
}

void SceneBuilder::add(const Shape& shape, const Attributes& attributes, const SourceSpan& place) {
    count(scene.objects.size(), place, "objects");
    if (is_in_body()) check_part(shape, attributes, place);
    Object object;
    object.shape = shape;
    object.material = attributes.material;
    object.name = name_index(attributes.name);
    object.casts_shadow = attributes.shadow;
    object.place = place;
    if (groups_.empty()) {
        if (object.material == none) object.material = 0;
        if (attributes.transforms.given)
            object.transform = transform_index(attributes.transforms.map, place);
    } else if (attributes.transforms.given) {
        count(nodes_.size(), place, "groups and moved objects within one group");
        Node node;
        node.map = attributes.transforms.map;
        node.moves = true;
        node.of_object = true;
        node.parent = groups_.back();
        object.transform = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(node);
    } else {
        object.transform = groups_.back();
    }
    scene.objects.push_back(object);
}

void SceneBuilder::add(const Light& light) {
    count(scene.lights.size(), light.place, "lights");
    if (is_in_body()) report_.error(Message::light_in_body, light.place);
    scene.lights.push_back(light);
    if (!groups_.empty()) light_nodes_.push_back(groups_.back());
}

std::uint32_t SceneBuilder::add(const Material& material, std::string_view name,
                                const SourceSpan& place) {
    count(scene.materials.size(), place, "materials");
    scene.materials.push_back(material);
    if (!name.empty()) {
        scene.material_names.resize(scene.materials.size());
        scene.material_names.back() = name;
    }
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

std::uint32_t SceneBuilder::add(const Texture& texture, const SourceSpan& place) {
    count(scene.textures.size(), place, "textures");
    scene.textures.push_back(texture);
    return static_cast<std::uint32_t>(scene.textures.size() - 1);
}

std::uint32_t SceneBuilder::vertex_colors(const SourceSpan& place) {
    if (vertex_colors_ == none) vertex_colors_ = add(Texture{VertexColors{}, {}}, place);
    return vertex_colors_;
}

void SceneBuilder::add(const Camera& camera) {
    count(scene.cameras.size(), camera.place, "cameras");
    scene.cameras.push_back(camera);
}

}  // namespace lancer
