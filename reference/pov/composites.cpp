#include "reference/pov/composites.h"

#include <algorithm>
#include <string>
#include <vector>

#include "model/parts.h"
#include "reference/pov/materials.h"
#include "reference/pov/shapes.h"

namespace lancer::reference::pov {

namespace {

using Kind = Composite::Kind;

/// The inner walls of a transparent union would be visible, so it becomes a merge.
std::string opening(Kind kind, bool clear) {
    switch (kind) {
        case Kind::unite:
            return clear ? "merge {" : "union {";
        case Kind::intersect:
            return "intersection {";
        case Kind::subtract:
            return "difference {";
    }
    return "";
}

void write_leaf(Writer& writer, const Composite::Leaf& leaf) {
    const Scene& scene = writer.scene;
    const Object& object = leaf.object;
    const ObjectSpace space = object_space(scene.transforms[object.transform], writer.scale);
    if (!open_shape(writer, object, space.own)) return;
    const std::string moved = transform(space.to_picture);
    const Object textured = texture_holder(scene, leaf);
    if (textured.transform == object.transform) write_texture(writer, object, space.own);
    if (!moved.empty()) writer.text.line(moved);
    if (textured.transform != object.transform) {
        const ObjectSpace home = object_space(scene.transforms[textured.transform], writer.scale);
        write_texture(writer, textured, home.own, transform(home.to_picture));
    }
    writer.text.close();
}

Bounds meeting(const Bounds& a, const Bounds& b) {
    Bounds both = a;
    for (int i = 0; i < 3; ++i) {
        both.low[i] = std::max(a.low[i], b.low[i]);
        both.high[i] = std::max(both.low[i], std::min(a.high[i], b.high[i]));
    }
    return both;
}

}  // namespace

void open_composite(Writer& writer, const Composite& composite) {
    bool clear = false;
    for (const Composite::Leaf& leaf : composite.leaves)
        clear =
            clear || lets_light_pass(writer.scene, writer.scene.materials[leaf.object.material]);
    std::vector<std::uint32_t> open;
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < composite.leaves.size(); ++i) {
        for (; !open.empty() && composite.nodes[open.back()].end <= i; open.pop_back())
            writer.text.close();
        for (; next < composite.nodes.size() && composite.nodes[next].begin == i; ++next) {
            writer.text.open(opening(composite.nodes[next].kind, clear));
            open.push_back(static_cast<std::uint32_t>(next));
        }
        write_leaf(writer, composite.leaves[i]);
    }
    for (; open.size() > 1; open.pop_back()) writer.text.close();
}

bool lets_light_pass(const Scene& scene, const Object& object) {
    bool any = false;
    for_each_part(scene, object, [&](const Object& part) {
        any = any || lets_light_pass(scene, scene.materials[part.material]);
    });
    return any;
}

Bounds composite_bounds(const Scene& scene, const Composite& composite) {
    struct Box {
        bool known = false;    ///< something was added
        bool endless = false;  ///< it is unbounded
        Bounds bounds;
    };
    std::vector<Box> nodes(composite.nodes.size());
    const auto add = [&](const Composite::Place& place, const Box& box) {
        if (place.parent == none) return;
        Box& whole = nodes[place.parent];
        const Kind kind = composite.nodes[place.parent].kind;
        if (kind == Kind::subtract && !place.first) return;
        if (!whole.known) {
            whole = box;
            whole.known = true;
        } else if (kind == Kind::unite) {
            whole.endless = whole.endless || box.endless;
            whole.bounds.add(box.bounds);
        } else if (whole.endless) {
            whole = box;
        } else if (!box.endless) {
            whole.bounds = meeting(whole.bounds, box.bounds);
        }
    };
    for (const Composite::Leaf& leaf : composite.leaves) {
        const std::optional<Bounds> own = shape_bounds(scene, leaf.object.shape);
        Box box{true, !own, {}};
        if (own) box.bounds = moved(scene.transforms[leaf.object.transform], *own);
        add(leaf.place, box);
    }
    for (std::size_t i = nodes.size(); i-- > 1;) add(composite.nodes[i].place, nodes[i]);
    return nodes.front().endless ? Bounds{} : nodes.front().bounds;
}

const Object& part_of(const Scene& scene, std::uint32_t object, std::uint32_t part) {
    const Object& whole = scene.objects[object];
    if (part == none) return whole;
    return scene.composites[std::get<CompositeRef>(whole.shape).composite].leaves[part].object;
}

const Composite::Node& meeting_node(const Composite& composite, std::uint32_t a, std::uint32_t b) {
    std::uint32_t node = composite.leaves[a].place.parent;
    while (composite.nodes[node].end <= b || composite.nodes[node].begin > b)
        node = composite.nodes[node].place.parent;
    return composite.nodes[node];
}

bool is_subtracted(const Composite& composite, const Composite::Leaf& leaf) {
    bool subtracted = false;
    for (Composite::Place place = leaf.place; place.parent != none;
         place = composite.nodes[place.parent].place)
        subtracted ^= composite.nodes[place.parent].kind == Kind::subtract && !place.first;
    return subtracted;
}

}  // namespace lancer::reference::pov
