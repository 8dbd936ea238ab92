#include "reference/pov/materials.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/pov/pigments.h"
#include "reference/pov/window.h"

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
    text.line(reflection(material) + (material.fresnel ? " conserve_energy" : ""));
    text.close();
}

void write_own_texture(Writer& writer, const Material& material, const Object& object,
                       PowerOfTen own) {
    write_pigment(writer, material, object, own);
    write_finish(writer, material);
}

/// A plain texture is the same at every size; a pattern is declared for each size that shows it.
std::pair<std::uint32_t, int> texture_key(const Scene& scene, const Object& object,
                                          PowerOfTen own) {
    const bool patterned = texture_of(scene, scene.materials[object.material]) != nullptr;
    return {object.material, patterned ? own.exponent : 0};
}

std::string texture_name(const Writer& writer, std::uint32_t material, int exponent) {
    const std::vector<std::string>& names = writer.scene.material_names;
    const std::string given = material < names.size() ? identifier(names[material]) : "";
    std::string name = fmt::format("T{}_{}", material, given.empty() ? "plain" : given);
    if (exponent != 0 && exponent != writer.window.exponent)
        name += fmt::format("_{}{}", exponent < 0 ? "m" : "p", std::abs(exponent));
    return name;
}

}  // namespace

void declare_textures(Writer& writer) {
    const Scene& scene = writer.scene;
    std::map<std::pair<std::uint32_t, int>, const Object*> shown_by;  // the first that does
    for (const Object& object : scene.objects) {
        if (depends_on_shape(scene, scene.materials[object.material])) continue;
        const ObjectSpace space = object_space(scene.transforms[object.transform], writer.window);
        shown_by.emplace(texture_key(scene, object, space.own), &object);
    }
    for (const auto& [key, object] : shown_by) {
        const auto& [material, exponent] = key;
        const std::string name = texture_name(writer, material, exponent);
        writer.text.open("#declare " + name + " = texture {");
        write_own_texture(writer, scene.materials[material], *object, {exponent});
        writer.text.close();
        writer.texture_names.emplace(key, name);
    }
}

void write_texture(Writer& writer, const Object& object, PowerOfTen own) {
    const auto declared = writer.texture_names.find(texture_key(writer.scene, object, own));
    if (declared != writer.texture_names.end()) {
        writer.text.line("texture { " + declared->second + " }");
        return;
    }
    writer.text.open("texture {");
    write_own_texture(writer, writer.scene.materials[object.material], object, own);
    writer.text.close();
}

void write_interior(Writer& writer, const Material& material, bool body) {
    if (!lets_light_pass(writer.scene, material)) {
        // Nothing gets in: the index serves the mirror alone.
        if (material.fresnel && material.ior != 1)
            writer.text.line("interior { ior " + number(material.ior) + " }");
        return;
    }
    const double most = max_component(material.absorption);
    if (!body || most <= 0) {
        writer.text.line("interior { ior " + number(body ? material.ior : 1) + " }");
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
