#include "reference/pov/glued_bodies.h"

#include <utility>

namespace lancer::reference::pov {

namespace {

Composite union_of(const Scene& scene, const std::vector<std::uint32_t>& members) {
    Composite whole;
    whole.nodes = {{Composite::Kind::unite, {}, 0, static_cast<std::uint32_t>(members.size())}};
    for (const std::uint32_t member : members) {
        const Object& object = scene.objects[member];
        whole.leaves.push_back({object, {0, whole.leaves.empty()}, object.transform});
    }
    return whole;
}

}  // namespace

Scene with_unions(Scene scene, const std::vector<std::vector<std::uint32_t>>& groups) {
    std::vector<bool> is_part(scene.objects.size());
    for (const std::vector<std::uint32_t>& members : groups) {
        scene.composites.push_back(union_of(scene, members));
        for (const std::uint32_t member : members) is_part[member] = member != members.front();
        Object& first = scene.objects[members.front()];
        first.shape = CompositeRef{static_cast<std::uint32_t>(scene.composites.size() - 1)};
        first.transform = 0;
    }
    std::vector<Object> objects;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (!is_part[i]) objects.push_back(std::move(scene.objects[i]));
    scene.objects = std::move(objects);
    return scene;
}

}  // namespace lancer::reference::pov
