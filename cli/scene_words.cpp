#include "cli/scene_words.h"

#include <fmt/format.h>

#include <variant>

#include "model/shape_facts.h"

namespace lancer::cli {

std::string describe(const Scene& scene, const Object& object) {
    std::string text(facts_of(scene, object.shape).name);
    if (object.name != none) text += fmt::format(" \"{}\"", scene.names[object.name]);
    return text;
}

std::string material_name(const Scene& scene, std::uint32_t material) {
    return material < scene.material_names.size() ? scene.material_names[material] : "";
}

std::string_view pattern_kind(const Texture& texture) {
    struct Kind {
        std::string_view operator()(const ImageTexture&) const { return "image"; }
        std::string_view operator()(const Checker&) const { return "checker"; }
        std::string_view operator()(const Gradient&) const { return "gradient"; }
        std::string_view operator()(const VertexColors&) const { return "vertex"; }
    };
    return std::visit(Kind{}, texture.pattern);
}

std::string describe_place(const SourceSpan& place, const SourceMap& sources) {
    if (place.file == SourceSpan::nowhere) return "";
    const auto [line, column] = sources.locate(place);
    return fmt::format("{}:{}:{}", sources.name(place.file), line, column);
}

}  // namespace lancer::cli
