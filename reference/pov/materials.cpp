#include "reference/pov/materials.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/pov/choices.h"
#include "reference/pov/export_scale.h"
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
    if (texture != nullptr && std::holds_alternative<VertexColors>(texture->pattern)) return true;
    return image && image->mapping == ImageTexture::Mapping::uv;
}

bool is_of_vertices(const Scene& scene, const Material& material) {
    const Texture* texture = texture_of(scene, material);
    return texture != nullptr && std::holds_alternative<VertexColors>(texture->pattern);
}

namespace {

std::string reflection(const Material& material) {
    if (!(max_component(material.reflection) > 0)) return "reflection 0";
    if (material.fresnel) return "reflection { " + rgb(material.reflection) + " fresnel on }";
    return "reflection { " + rgb(material.reflection) + " }";
}

// Writes every value, so that POV-Ray's defaults do not matter.
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
    // conserve_energy reduces the transmitted light by what fresnel reflects, and changes nothing
    // else.
    text.line(reflection(material) + (material.fresnel ? " conserve_energy" : ""));
    text.close();
}

void write_own_texture(Writer& writer, const Material& material, const Object& object,
                       PowerOfTen own) {
    write_pigment(writer, material, object, own);
    write_finish(writer, material);
}

/// A plain texture is the same at every size. A pattern is declared for each size that uses it.
TextureKey texture_key(const Writer& writer, const Object& object, PowerOfTen own) {
    TextureKey key{object.material, {}};
    if (texture_of(writer.scene, writer.scene.materials[object.material]) != nullptr)
        key.second = own.exponent - writer.scale.exponent;
    return key;
}

/// `T3_brick`, `T3_brick_m2`: the material's number and its name, of which POV-Ray reads at most 40
/// bytes; then its size relative to the scene, if it differs.
std::string texture_name(const Writer& writer, const TextureKey& key) {
    const auto [material, decades] = key;
    const std::vector<std::string>& names = writer.scene.material_names;
    const bool named = material < names.size() && !names[material].empty();
    std::string name = fmt::format("T{}_{}", material,
                                   named ? identifier(names[material]).substr(0, 24) : "plain");
    if (decades != 0) name += fmt::format("_{}{}", decades < 0 ? "m" : "p", std::abs(decades));
    return name;
}

}  // namespace

void declare_textures(Writer& writer) {
    const Scene& scene = writer.scene;
    std::map<TextureKey, std::pair<Object, PowerOfTen>> shown_by;  // the first object that does
    const auto note = [&](const Object& object) {
        if (depends_on_shape(scene, scene.materials[object.material])) return;
        const ObjectSpace space = object_space(scene.transforms[object.transform], writer.scale);
        shown_by.emplace(texture_key(writer, object, space.own), std::pair{object, space.own});
    };
    for (const Object& object : scene.objects) {
        const auto* ref = std::get_if<CompositeRef>(&object.shape);
        if (ref == nullptr) note(object);
        if (ref == nullptr) continue;
        for (const Composite::Leaf& leaf : scene.composites[ref->composite].leaves)
            note(texture_holder(scene, leaf));
    }
    for (const auto& [key, shower] : shown_by) {
        const auto& [object, own] = shower;
        const std::string name = texture_name(writer, key);
        writer.text.open("#declare " + name + " = texture {");
        write_own_texture(writer, scene.materials[object.material], object, own);
        writer.text.close();
        writer.texture_names.emplace(key, name);
    }
}

void write_vertex_textures(Writer& writer, const Material& material,
                           const std::vector<Color>& colors) {
    writer.text.open(fmt::format("texture_list {{ {},", colors.size()));
    for (const Color& color : colors) {
        writer.text.open("texture {");
        writer.text.line(plain_pigment(color, material));
        write_finish(writer, material);
        writer.text.close();
    }
    writer.text.close();
}

void write_texture(Writer& writer, const Object& object, PowerOfTen own, const std::string& moved) {
    if (is_of_vertices(writer.scene, writer.scene.materials[object.material]))
        return;  // the mesh has the texture
    const auto declared = writer.texture_names.find(texture_key(writer, object, own));
    if (declared != writer.texture_names.end()) {
        writer.text.line("texture { " + declared->second + (moved.empty() ? "" : " " + moved) +
                         " }");
        return;
    }
    writer.text.open("texture {");
    write_own_texture(writer, writer.scene.materials[object.material], object, own);
    if (!moved.empty()) writer.text.line(moved);
    writer.text.close();
}

Object texture_holder(const Scene& scene, const Composite::Leaf& leaf) {
    Object holder = leaf.object;
    const Material& material = scene.materials[holder.material];
    if (texture_of(scene, material) != nullptr && !depends_on_shape(scene, material))
        holder.transform = leaf.texture_space;
    return holder;
}

void write_interior(Writer& writer, const Material& material, bool body, bool passes) {
    if (!passes) {
        // No light enters: the index is only for the mirror.
        if (material.fresnel) writer.text.line("interior { ior " + number(material.ior) + " }");
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
    writer.text.line(fmt::format("ior {} fade_power {} fade_distance {} fade_color {}",
                                 number(material.ior), beer_lambert, number(writer.scale(1 / most)),
                                 rgb(fade_color)));
    writer.text.close();
}

}  // namespace lancer::reference::pov
