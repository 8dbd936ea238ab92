#include "model/material.h"

#include "parser/blocks/blocks.h"
#include "parser/blocks/brightness.h"
#include "parser/rules.h"

namespace lancer::blocks {
namespace {

struct MaterialSpec : Material {
    rules::ColorOrTexture surface;
};

template <auto Member, class Rule>
constexpr Field of_material(std::string_view name, std::string_view standard,
                            std::string_view doc) {
    return {name,
            Rule::takes,
            standard,
            doc,
            words_of<Rule>(),
            false,
            [](const Value& value, void* owner, std::string& instead) {
                return Rule::read(value, static_cast<MaterialSpec*>(owner)->*Member, instead);
            }};
}

constexpr Field material_fields[] = {
    of_material<&MaterialSpec::surface, rules::ColorOrTextureRule>(
        "color", "[1, 1, 1]",
        "colour of the surface, a texture, or vertex: the colours of a mesh's vertices"),
    of_material<&Material::ambient, rules::NotNegative>("ambient", "0.1",
                                                        "share of the global ambient light"),
    of_material<&Material::diffuse, rules::NotNegative>("diffuse", "0.6",
                                                        "share of the light that is scattered"),
    of_material<&Material::emission, rules::NumberOrColor>(
        "emission", "0", "light from the surface itself, times its colour"),
    of_material<&Material::phong, rules::NotNegative>("phong", "0",
                                                      "strength of the Phong highlight"),
    of_material<&Material::shininess, rules::NotNegative>("shininess", "40",
                                                          "exponent of the Phong highlight"),
    of_material<&Material::blinn, rules::NotNegative>("blinn", "0",
                                                      "strength of the Blinn highlight"),
    of_material<&Material::roughness, rules::Positive>("roughness", "0.05",
                                                       "1 / exponent of the Blinn highlight"),
    of_material<&Material::metallic, rules::Share>(
        "metallic", "0", "how much the surface's colour tints highlights"),
    of_material<&Material::reflection, rules::NumberOrColor>("reflection", "0",
                                                             "strength of the ideal mirror"),
    of_material<&Material::fresnel, rules::Flag>(
        "fresnel", "false", "true: reflection weighted by Fresnel's equations for ior"),
    of_material<&Material::transmission, rules::Share>("transmission", "0",
                                                       "share of light that passes untinted"),
    of_material<&Material::filter, rules::Share>(
        "filter", "0", "share of light that passes, tinted by the colour"),
    of_material<&Material::ior, rules::Positive>("ior", "1", "index of refraction"),
    of_material<&Material::absorption, rules::ColorRule>(
        "absorption", "[0, 0, 0]", "Beer-Lambert absorption inside, per unit of length"),
    of_material<&Material::diffuse_transmission, rules::NotNegative>(
        "diffuse_transmission", "0", "share of the light from behind that is scattered"),
    of_material<&Material::phong_transmission, rules::NotNegative>(
        "phong_transmission", "0", "strength of the highlight of light from behind"),
};

}  // namespace

const BlockInfo material{"material", "", material_fields, {}, "the appearance of a surface"};

void make_material(BlockReader& block, std::uint32_t& result) {
    MaterialSpec spec;
    block.read(&spec);
    // The sum of two decimal fractions may be wrong by one rounding: 0.7 + 0.3 counts as 1.
    constexpr double rounding = 2.220446049250313e-16;
    if (spec.filter + spec.transmission > 1 + rounding)
        block.error(Message::passes_too_much,
                    block.place(block.has("filter") ? "filter" : "transmission"),
                    to_text(spec.filter + spec.transmission));
    if (!block.good()) return;
    if (max_component(spec.emission) == 0)
        warn_bright_surface(block.report(), block.place("color"), spec.surface.color);
    Material made = spec;
    made.color = spec.surface.color;
    made.texture = spec.surface.texture;
    if (spec.surface.of_vertices) made.texture = block.builder().vertex_colors(block.place());
    result = block.builder().add(made, block.name(), block.place());
}

}  // namespace lancer::blocks
