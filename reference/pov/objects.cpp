#include "reference/pov/shapes.h"

#include <fmt/format.h>

#include "model/bodies.h"
#include "model/parts.h"
#include "reference/pov/composites.h"
#include "reference/pov/materials.h"

namespace lancer::reference::pov {

namespace {

/// Writes an object without its end. False when it was refused.
bool open_object(Writer& writer, std::uint32_t index) {
    const Scene& scene = writer.scene;
    const Object& object = scene.objects[index];
    bool shines_through = false;
    for_each_part(scene, object, [&](const Object& part) {
        shines_through = shines_through || scene.materials[part.material].phong_transmission > 0;
    });
    if (shines_through) {
        writer.refuse(object.place, "POV-Ray has no highlights from light behind a surface",
                      "remove 'phong_transmission' from the material to export the scene");
        return false;
    }
    const ObjectSpace space = object_space(scene.transforms[object.transform], writer.scale);
    if (object.name != none) writer.text.line("// \"" + comment(scene.names[object.name]) + "\"");
    if (!open_shape(writer, object, space.own)) return false;
    if (!std::holds_alternative<CompositeRef>(object.shape))
        // before the transform, which applies to it as well
        write_texture(writer, object, space.own);
    return true;
}

/// Writes what belongs to the object but not to the parts of a merged one.
void write_inside_and_shadow(Writer& writer, const Object& object) {
    const Scene& scene = writer.scene;
    write_interior(writer, scene.materials[object.material], is_body(scene, object.shape),
                   lets_light_pass(scene, object));
    if (!object.casts_shadow || !scene.settings.shadows) writer.text.line("no_shadow");
}

void write_transform(Writer& writer, const Object& object) {
    const ObjectSpace space = object_space(writer.scene.transforms[object.transform], writer.scale);
    const std::string moved = transform(space.to_picture);
    if (!moved.empty()) writer.text.line(moved);
}

void declare_mesh_of(Writer& writer, const Object& object) {
    writer.in_composite = std::holds_alternative<CompositeRef>(object.shape);
    for_each_part(writer.scene, object, [&](const Object& part) {
        declare_mesh(writer, part,
                     object_space(writer.scene.transforms[part.transform], writer.scale).own);
    });
}

}  // namespace

void write_object(Writer& writer, std::uint32_t index) {
    const Object& object = writer.scene.objects[index];
    declare_mesh_of(writer, object);
    if (!open_object(writer, index)) return;
    write_inside_and_shadow(writer, object);
    write_transform(writer, object);
    writer.text.close();
}

void write_merged(Writer& writer, const std::vector<std::uint32_t>& members) {
    const Scene& scene = writer.scene;
    for (const std::uint32_t member : members) declare_mesh_of(writer, scene.objects[member]);
    writer.text.open("merge {");
    for (const std::uint32_t member : members) {
        if (!open_object(writer, member)) continue;
        write_transform(writer, scene.objects[member]);
        writer.text.close();
    }
    write_inside_and_shadow(writer, scene.objects[members.front()]);
    writer.text.close();
}

}  // namespace lancer::reference::pov
