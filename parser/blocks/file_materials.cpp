#include "parser/blocks/file_materials.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/io/obj_materials.h"
#include "model/io/text_scanner.h"
#include "model/mesh_pieces.h"
#include "parser/evaluation/files.h"

namespace lancer {
namespace {

/// Reads the materials once, even when many frames show the mesh.
const io::ObjMaterials& materials_of(const BlockContext& context, const MeshWithMaterials& whole) {
    auto& known = context.program.mesh_materials;
    const auto at = known.find(whole.loaded.get());
    if (at != known.end()) return at->second;
    const auto read = [&](const std::string& path) {
        return context.files.loader().text(path, context.meter.limits().source_bytes);
    };
    return known.emplace(whole.loaded.get(), io::find_materials(*whole.loaded, whole.path, read))
        .first->second;
}

/// The image of a material as a texture of the scene. `none` when the material has no image, the
/// mesh has no texture coordinates, or the image cannot be read; the last is a warning.
std::uint32_t texture_of(const BlockContext& context, const io::MtlMaterial& material, bool has_uvs,
                         const SourceSpan& place) {
    if (material.image.empty() || !has_uvs) return none;
    const auto pixels =
        context.files.image_of_mesh(material.image, io::ColorSpace::automatic, place);
    if (pixels == nullptr) return none;
    SceneBuilder& builder = context.builder;
    const auto [at, is_new] = builder.image_indices.try_emplace(
        {material.image, true}, static_cast<std::uint32_t>(builder.scene.images.size()));
    if (is_new) builder.scene.images.push_back({material.image, true, pixels});
    Texture texture;
    texture.pattern = ImageTexture{at->second, ImageTexture::Mapping::uv,
                                   ImageTexture::Filter::bilinear, ImageTexture::Wrap::repeat};
    return builder.add(texture, place);
}

std::uint32_t add_material(const BlockContext& context, const io::MtlMaterial& from,
                           const Mesh& shown_by, const SourceSpan& place) {
    const std::uint32_t texture = texture_of(context, from, !shown_by.uvs.empty(), place);
    Material made = material_of(from, texture != none);
    made.texture = texture;
    return context.builder.add(made, io::quotable(from.name), place);
}

/// Splits the mesh by material. Each piece keeps the normals that its faces have in the whole mesh.
const std::vector<std::shared_ptr<const Mesh>>& pieces_of(
    Program& program, const MeshWithMaterials& whole, const std::vector<std::uint32_t>& number_of,
    std::uint32_t count) {
    auto& pieces = program.mesh_pieces[{whole.mesh.get(), whole.smooth}];
    if (!pieces.empty()) return pieces;
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t material : whole.loaded->face_materials)
        numbers.push_back(number_of[material]);
    const bool averages = whole.smooth && whole.mesh->normals.empty();
    for (Mesh& piece : averages ? split(with_averaged_normals(*whole.mesh), numbers, count)
                                : split(*whole.mesh, numbers, count))
        pieces.push_back(std::make_shared<const Mesh>(std::move(piece)));
    return pieces;
}

std::vector<Part> make_parts(const BlockContext& context, const MeshWithMaterials& whole) {
    SceneBuilder& builder = context.builder;
    const io::ObjMaterials& found = materials_of(context, whole);
    for (const std::string& text : found.warnings)
        context.report.warning(Message::mesh_file, whole.place, text);
    // Faces whose materials have no content look the same, so they form one piece.
    std::vector<std::uint32_t> number_of;
    std::vector<const io::MtlMaterial*> contents;
    std::uint32_t plain = none;
    for (const auto& material : found.materials) {
        std::uint32_t number = material ? none : plain;
        if (number == none) {
            number = static_cast<std::uint32_t>(contents.size());
            contents.push_back(material ? &*material : nullptr);
        }
        if (!material) plain = number;
        number_of.push_back(number);
    }
    std::vector<std::shared_ptr<const Mesh>> meshes{whole.mesh};
    if (contents.size() > 1) {
        meshes = pieces_of(context.program, whole, number_of,
                           static_cast<std::uint32_t>(contents.size()));
        for (const auto& piece : meshes) builder.pieces.insert(piece.get());
    }
    std::vector<Part> parts;
    for (std::size_t i = 0; i < contents.size(); ++i) {
        parts.push_back({MeshRef{mesh_index(builder, meshes[i]), whole.smooth, whole.inside}, 0});
        if (contents[i] != nullptr)
            parts.back().material = add_material(context, *contents[i], *meshes[i], whole.place);
    }
    return parts;
}

}  // namespace

Material material_of(const io::MtlMaterial& from, bool textured) {
    constexpr Color white(1.0);
    Material m;
    const Color diffuse = from.diffuse.value_or(from.emission ? Color(0.0) : white);
    const Color emission = from.emission.value_or(Color(0.0));
    const Color specular = from.specular.value_or(Color(0.0));
    const int model = from.illumination.value_or(2);

    // The colour is Kd. Emission is a multiple of the colour, so where Kd is black and Ke is not,
    // the colour must not become zero.
    constexpr double spark = 0x1p-40;
    for (int i = 0; i < 3; ++i) {
        m.color[i] = diffuse[i] > 0 ? diffuse[i] : emission[i] > 0 ? spark : 0;
        m.emission[i] = emission[i] > 0 ? emission[i] / m.color[i] : 0;
    }
    m.diffuse = 1;
    if (textured) {  // the image replaces the colour
        const double strength = max_component(diffuse);
        m.diffuse = strength > 0 ? strength : 1;
        m.emission = emission;
    }
    // Ka is a share of the room's light, which is a tenth of white here unless the scene says
    // otherwise.
    constexpr double room = 0.1;
    const double brightest = max_component(textured ? Color(m.diffuse) : diffuse);
    if (from.ambient && brightest > 0)
        m.ambient = room * std::min(max_component(*from.ambient) / brightest, 1.0);
    if (textured) m.ambient *= m.diffuse;
    if (model == 0) {  // the colour without lighting
        m.emission = m.emission + white * m.diffuse;
        m.diffuse = m.ambient = 0;
    }

    if (model >= 2) {
        m.phong = max_component(specular);
        m.shininess = from.shininess.value_or(m.shininess);
    }
    if (model >= 3 && model <= 9) m.reflection = specular;
    m.fresnel = model == 5 || model == 7;
    m.transmission = 1 - from.opacity.value_or(1);
    // Nothing is refracted where nothing is transmitted; files write an index all the same.
    if (m.transmission > 0 || m.fresnel) m.ior = from.ior.value_or(1);
    return m;
}

std::uint32_t mesh_index(SceneBuilder& builder, const std::shared_ptr<const Mesh>& mesh) {
    auto& meshes = builder.scene.meshes;
    // Instances of one file need not follow each other: the pointer identifies the mesh.
    const auto [at, is_new] =
        builder.mesh_indices.emplace(mesh.get(), static_cast<std::uint32_t>(meshes.size()));
    if (is_new) meshes.push_back(mesh);
    return at->second;
}

MakeParts parts_of(const BlockContext& context, const MeshWithMaterials& whole) {
    // Warnings name the calls that led to the mesh, not those that run at the end of the group.
    return [&context, whole, calls = context.report.calls](bool has_material) {
        SceneBuilder& builder = context.builder;
        if (has_material)
            return std::vector<Part>{
                {MeshRef{mesh_index(builder, whole.mesh), whole.smooth, whole.inside}}};
        const auto [at, is_new] =
            builder.mesh_parts.try_emplace({whole.mesh.get(), whole.smooth, whole.inside});
        if (is_new) {
            const std::vector<CallSite> here = std::exchange(context.report.calls, calls);
            at->second = make_parts(context, whole);
            context.report.calls = here;
        }
        return at->second;
    };
}

}  // namespace lancer
