#include "cli/scene_summary.h"

#include <fmt/format.h>

#include <array>
#include <set>

#include "model/parts.h"

namespace lancer::cli {
namespace {

// In the order of the variants' alternatives.
constexpr std::array<std::string_view, std::variant_size_v<Shape>> shape_names{
    "sphere", "box",   "cylinder", "cone",  "plane",    "triangle",
    "mesh",   "patch", "lathe",    "prism", "composite"};
constexpr std::array<std::string_view, std::variant_size_v<LightKind>> light_names{
    "point light", "directional light", "spot light"};

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
std::string describe(const Scene& scene, const Demand& demand) {
    if (demand.object == none) return "light";
    const Object& object = scene.objects[demand.object];
    std::string text(shape_names[object.shape.index()]);
    if (object.name != none) text += fmt::format(" \"{}\"", scene.names[object.name]);
    if (object.material < scene.material_names.size() &&
        !scene.material_names[object.material].empty())
        text += fmt::format(", material {}", scene.material_names[object.material]);
    return text;
}

std::string describe_place(const SourceSpan& place, const SourceMap& sources) {
    if (place.file == SourceSpan::nowhere) return "";
    const auto [line, column] = sources.locate(place);
    return fmt::format("{}:{}:{}", sources.name(place.file), line, column);
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
                {feature, describe(scene, *demand), describe_place(demand->place, sources)});
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
