// Bodies made of bodies: SceneBuilder's part for union, intersection and difference.
#include <string>
#include <string_view>
#include <utility>

#include "model/shape_facts.h"
#include "parser/report.h"
#include "parser/scene_builder.h"

namespace lancer {
namespace {

std::string_view word_of(const std::optional<Composite::Kind>& joint) {
    if (!joint) return "group";
    switch (*joint) {
        case Composite::Kind::unite:
            return "union";
        case Composite::Kind::intersect:
            return "intersection";
        case Composite::Kind::subtract:
            return "difference";
    }
    return "";
}

}  // namespace

void SceneBuilder::check_part(const Shape& shape, const Attributes& attributes,
                              const SourceSpan& place) {
    Node& group = nodes_[groups_.back()];
    group.holds_body = true;
    if (!attributes.shadow) report_.warning(Message::shadow_of_part, place);
    if (bodies_.holds(shape)) return;
    const Sheet sheet = facts_of(scene, shape).sheet;
    Diagnostic* error = report_.error(Message::sheet_in_body, place, sheet.what);
    if (error != nullptr) error->hint = sheet.hint;
}

/// Called at the end of a group.
void SceneBuilder::check_body(const Node& node) {
    if (!node.in_body) return;
    // A statement with an error may have been meant to be a body.
    if (!node.holds_body && !report_.any_error())
        report_.error(Message::body_of_nothing, node.place, word_of(node.joint));
    if (node.parent == none) return;
    nodes_[node.parent].holds_body = true;
    if (!node.shadow && nodes_[node.parent].in_body)
        report_.warning(Message::shadow_of_part, node.place);
}

/// The composite's node for a node of the builder. It and its missing ancestors are made here.
std::uint32_t SceneBuilder::tree_node(Composite& composite, std::vector<std::uint32_t>& children,
                                      std::uint32_t node) {
    std::vector<std::uint32_t> missing;
    std::uint32_t parent = none;
    for (std::uint32_t i = node;; i = nodes_[i].parent) {
        parent = nodes_[i].in_tree;
        if (parent != none) break;
        if (!nodes_[i].of_object) missing.push_back(i);
        if (i == nodes_[i].whole) break;
    }
    for (; !missing.empty(); missing.pop_back()) {
        Node& from = nodes_[missing.back()];
        Composite::Node made;
        made.kind = from.joint.value_or(Composite::Kind::unite);
        made.place.parent = parent;
        made.place.first = parent != none && children[parent]++ == 0;
        made.begin = static_cast<std::uint32_t>(composite.leaves.size());
        from.in_tree = static_cast<std::uint32_t>(composite.nodes.size());
        composite.nodes.push_back(made);
        children.push_back(0);
        parent = from.in_tree;
    }
    return parent;
}

/// Objects of the outermost group that are parts of one body become leaves of a composite. The
/// composite takes the place of its first part.
void SceneBuilder::make_composites(const std::vector<std::uint32_t>& node_of,
                                   const std::vector<bool>& own_material) {
    std::uint32_t current = none;
    std::vector<std::uint32_t> children;
    for (std::size_t i = 0; i < node_of.size(); ++i) {
        const std::uint32_t node = node_of[i];
        const std::uint32_t whole = nodes_[node].whole;
        if (whole == none) continue;
        Object& slot = scene.objects[first_object_ + i];
        const Object part = slot;
        if (whole == current) {
            absorbed_.resize(node_of.size());
            absorbed_[i] = true;
        } else {
            current = whole;
            children.clear();
            slot = Object{};
            slot.shape = CompositeRef{static_cast<std::uint32_t>(scene.composites.size())};
            slot.material = nodes_[whole].material;
            slot.name = nodes_[whole].name;
            slot.casts_shadow = nodes_[whole].shadow;
            slot.place = nodes_[whole].place;
            scene.composites.emplace_back();
        }
        Composite& composite = scene.composites.back();
        Composite::Leaf leaf;
        leaf.place.parent = tree_node(composite, children, node);
        leaf.place.first = children[leaf.place.parent]++ == 0;
        leaf.object = part;
        if (part.material == none) leaf.object.material = 0;
        const std::uint32_t space = own_material[i] ? none : nodes_[node].space;
        leaf.texture_space = space == none ? part.transform : transform_of(space, part.place);
        composite.leaves.push_back(leaf);
        const auto end = static_cast<std::uint32_t>(composite.leaves.size());
        for (std::uint32_t n = leaf.place.parent; n != none; n = composite.nodes[n].place.parent)
            composite.nodes[n].end = end;
    }
}

}  // namespace lancer
