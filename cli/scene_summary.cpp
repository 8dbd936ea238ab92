#include "cli/scene_summary.h"

#include <fmt/format.h>

#include <array>
#include <set>

#include "cli/scene_words.h"
#include "model/light_facts.h"
#include "model/parts.h"
#include "model/shape_facts.h"

namespace lancer::cli {
namespace {

/// Counts kinds of things, in the order of their variant's alternatives.
template <class Kinds>
class Counter {
  public:
    void add(const Kinds& thing, std::string_view name) {
        Count& count = counts_[thing.index()];
        count.kind = name;
        ++count.number;
    }
    /// The kinds that occur.
    std::vector<Count> found() const {
        std::vector<Count> found;
        for (const Count& count : counts_)
            if (count.number > 0) found.push_back(count);
        return found;
    }

  private:
    std::array<Count, std::variant_size_v<Kinds>> counts_{};
};

/// Describes what asks for a feature: a shape with its name and its material's name, or a light.
std::string describe_demand(const Scene& scene, const Demand& demand) {
    if (demand.object == none) return "light";
    const Object& object = scene.objects[demand.object];
    const std::string material = material_name(scene, object.material);
    return describe(scene, object) + (material.empty() ? "" : ", material " + material);
}

}  // namespace

SceneSummary summarize(const Scene& scene, const SourceMap& sources) {
    SceneSummary summary;
    Counter<LightKind> lights;
    for (const Light& light : scene.lights) lights.add(light.kind, facts_of(light.kind).name);
    summary.lights = lights.found();
    Counter<Shape> shapes;
    std::set<std::uint32_t> materials;
    for (const Object& object : scene.objects) {
        const ShapeFacts facts = facts_of(scene, object.shape);
        shapes.add(object.shape, facts.name);
        summary.triangles += facts.triangles;
        materials.insert(object.material);
        for_each_part(scene, object, [&](const Object& part) { materials.insert(part.material); });
    }
    summary.shapes = shapes.found();
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
