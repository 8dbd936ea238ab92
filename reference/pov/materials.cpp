#include "reference/pov/materials.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/pov/pigments.h"

namespace lancer::reference::pov {

const Texture* texture_of(const Scene& scene, const Material& material) {
    if (material.texture == none || !scene.settings.textures) return nullptr;
    return &scene.textures[material.texture];
}

bool lets_light_pass(const Scene& scene, const Material& material) {
    if (material.filter > 0 || material.transmission > 0) return true;
    const Texture* texture = texture_of(scene, material);
    const auto* image = texture ? std::get_if<ImageTexture>(&texture->pattern) : nullptr;
    return image && (image->wrap == ImageTexture::Wrap::once ||
                     scene.images[image->image].pixels->channels == 4);
}

bool depends_on_shape(const Scene& scene, const Material& material) {
    const Texture* texture = texture_of(scene, material);
    const auto* image = texture ? std::get_if<ImageTexture>(&texture->pattern) : nullptr;
    return image && image->mapping == ImageTexture::Mapping::uv;
}

namespace {

std::string reflection(const Material& material) {
    if (material.reflection == Color(0, 0, 0)) return "reflection 0";
    if (material.fresnel) return "reflection { " + rgb(material.reflection) + " fresnel on }";
    return "reflection { " + rgb(material.reflection) + " }";
}

// Every value is written, whatever POV-Ray's defaults are.
void write_finish(Writer& writer, const Material& material) {
    Text& text = writer.text;
    text.open("finish {");
    std::string diffuse = "diffuse " + number(material.diffuse);
    if (material.diffuse_transmission > 0)
        diffuse += ", " + number(material.diffuse_transmission);  // light from behind
    text.line(fmt::format("ambient {} {} brilliance 1 emission {}", number(material.ambient),
                          diffuse, rgb(writer.lit(material.emission))));
    text.line(fmt::format("phong {} phong_size {} specular {} roughness {} metallic {}",
                          number(material.phong), number(material.shininess),
                          number(material.blinn), number(material.roughness),
                          number(material.metallic)));
    // conserve_energy takes from what passes what fresnel mirrors, and touches nothing else.
    text.line(reflection(material) + (material.fresnel ? " conserve_energy on" : ""));
    text.close();
}

void write_own_texture(Writer& writer, const Material& material, const Object& object,
                       PowerOfTen own) {
    write_pigment(writer, material, object, own);
    write_finish(writer, material);
}

}  // namespace

void declare_textures(Writer& writer) {
    const Scene& scene = writer.scene;
    std::vector<const Object*> shown_by(scene.materials.size());  // the first that does
    for (const Object& object : scene.objects)
        if (!shown_by[object.material]) shown_by[object.material] = &object;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        if (!shown_by[i] || depends_on_shape(scene, material)) continue;
        const std::string given = i < scene.material_names.size() ? scene.material_names[i] : "";
        const std::string name =
            fmt::format("T{}_{}", i, given.empty() ? "plain" : identifier(given));
        writer.text.open("#declare " + name + " = texture {");
        write_own_texture(writer, material, *shown_by[i], writer.window);
        writer.text.close();
        writer.texture_names.emplace(i, name);
    }
}

void write_texture(Writer& writer, const Object& object, PowerOfTen own) {
    const Material& material = writer.scene.materials[object.material];
    const auto declared = writer.texture_names.find(object.material);
    if (declared == writer.texture_names.end()) {
        writer.text.open("texture {");
        write_own_texture(writer, material, object, own);
        writer.text.close();
        return;
    }
    const PowerOfTen rest{own.exponent - writer.window.exponent};
    const bool patterned = texture_of(writer.scene, material) && rest.exponent != 0;
    writer.text.line("texture { " + declared->second +
                     (patterned ? " scale " + number(rest.factor()) : "") + " }");
}

void write_interior(Writer& writer, const Material& material, bool body) {
    const bool passes = lets_light_pass(writer.scene, material);
    if (!body) {
        if (passes) writer.text.line("interior { ior 1 }");
        return;
    }
    const double most = max_component(material.absorption);
    if (most <= 0 && material.ior == 1) return;
    if (most <= 0) {
        writer.text.line("interior { ior " + number(material.ior) + " }");
        return;
    }
    // Beer-Lambert: exp(-(1 - fade_color) s / fade_distance) per channel, for fade_power >= 1000.
    const Color fade_color = Color(1.0) - material.absorption / most;
    writer.text.open("interior {  // absorption " + vector(material.absorption) + " per unit");
    writer.text.line(fmt::format("ior {} fade_power 1001 fade_distance {} fade_color {}",
                                 number(material.ior), number(writer.window(1 / most)),
                                 rgb(fade_color)));
    writer.text.close();
}

}  // namespace lancer::reference::pov
