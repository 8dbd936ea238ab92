#include "cli/scene_summary.h"

#include <fmt/format.h>

#include <array>
#include <set>

#include "cli/scene_words.h"
#include "model/parts.h"

namespace lancer::cli {
namespace {

template <class Things, class IndexOf, std::size_t N>
std::vector<Count> count_kinds(const Things& things, IndexOf index_of,
                               const std::array<std::string_view, N>& names) {
    std::array<std::uint64_t, N> numbers{};
    for (const auto& thing : things) ++numbers[index_of(thing)];
    std::vector<Count> counts;
    for (std::size_t i = 0; i < N; ++i) {
        if (numbers[i] > 0) counts.push_back({names[i], numbers[i]});
    }
    return counts;
}

struct TrianglesOf {
    const Scene& scene;

    std::uint64_t operator()(const Sphere&) const { return 0; }
    std::uint64_t operator()(const Box&) const { return 0; }
    std::uint64_t operator()(const Plane&) const { return 0; }
    std::uint64_t operator()(const Cylinder&) const { return 0; }
    std::uint64_t operator()(const Cone&) const { return 0; }
    std::uint64_t operator()(const Torus&) const { return 0; }
    std::uint64_t operator()(const Triangle&) const { return 1; }
    std::uint64_t operator()(const MeshRef& ref) const {
        return scene.meshes[ref.mesh]->faces.size();
    }
    std::uint64_t operator()(const PatchRef&) const { return 0; }
    std::uint64_t operator()(const LatheRef&) const { return 0; }
    std::uint64_t operator()(const PrismRef&) const { return 0; }
    std::uint64_t operator()(const CompositeRef& ref) const {
        std::uint64_t sum = 0;
        for (const Composite::Leaf& leaf : scene.composites[ref.composite].leaves)
            sum += std::visit(*this, leaf.object.shape);
        return sum;
    }
};

/// Who asks: a shape with its name and its material's, or a light.
std::string describe_demand(const Scene& scene, const Demand& demand) {
    if (demand.object == none) return "light";
    const Object& object = scene.objects[demand.object];
    const std::string material = material_name(scene, object.material);
    return describe(scene, object) + (material.empty() ? "" : ", material " + material);
}

}  // namespace

SceneSummary summarize(const Scene& scene, const SourceMap& sources) {
    SceneSummary summary;
    summary.shapes = count_kinds(
        scene.objects, [](const Object& object) { return object.shape.index(); }, shape_names);
    summary.lights = count_kinds(
        scene.lights, [](const Light& light) { return light.kind.index(); }, light_names);
    std::set<std::uint32_t> materials;
    for (const Object& object : scene.objects) {
        summary.triangles += std::visit(TrianglesOf{scene}, object.shape);
        materials.insert(object.material);
        for_each_part(scene, object, [&](const Object& part) { materials.insert(part.material); });
    }
    summary.meshes = scene.meshes.size();
    summary.materials = materials.size();
    summary.textures = scene.textures.size();
    summary.images = scene.images.size();

    const Requirements requirements = requirements_of(scene, scene.settings);
    for (std::size_t i = 0; i < feature_count; ++i) {
        const auto feature = static_cast<Feature>(i);
        if (const auto& demand = requirements.demand(feature)) {
            summary.requirements.push_back(
                {feature, describe_demand(scene, *demand), describe_place(demand->place, sources)});
        }
    }
    return summary;
}

std::uint64_t total(const std::vector<Count>& counts) {
    std::uint64_t sum = 0;
    for (const Count& count : counts) sum += count.number;
    return sum;
}

}  // namespace lancer::cli
