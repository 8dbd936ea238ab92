#include "reference/pov/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

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

/// Whether the point, in the shape's own space, lies in a ball or a box. False for all other
/// shapes.
struct Holds {
    const Vec3d& p;

    bool operator()(const Sphere& s) const { return length(p - s.center) < s.radius; }
    bool operator()(const Box& s) const {
        return p.x > s.min.x && p.y > s.min.y && p.z > s.min.z && p.x < s.max.x && p.y < s.max.y &&
               p.z < s.max.z;
    }
    bool operator()(const auto&) const { return false; }
};

/// Whether the object is an opaque room around the camera in a scene with Fresnel glass.
///
/// POV-Ray counts the room among the bodies around the ray. Where the ray leaves a glass, Fresnel's
/// term then takes the glass itself for what lies beyond, and mirrors nothing. No ray leaves the
/// room, so that it may as well be written inside out: then the camera is not in it.
bool is_room_around_glass(const Writer& writer, const Object& object) {
    const Scene& scene = writer.scene;
    const bool may_be =
        std::holds_alternative<Sphere>(object.shape) || std::holds_alternative<Box>(object.shape);
    if (!may_be || lets_light_pass(scene, object)) return false;
    const bool has_glass =
        std::any_of(scene.materials.begin(), scene.materials.end(),
                    [&](const Material& m) { return m.fresnel && lets_light_pass(scene, m); });
    if (!has_glass) return false;
    const Affine<long double> to_own =
        inverse(convert<long double>(scene.transforms[object.transform]));
    const Vec3d eye = convert<double>(
        map_point(to_own, convert<long double>(scene.cameras[writer.view.camera].position)));
    return std::visit(Holds{eye}, object.shape);
}

/// Writes what belongs to the object but not to the parts of a merged one.
void write_inside_and_shadow(Writer& writer, const Object& object) {
    const Scene& scene = writer.scene;
    if (is_room_around_glass(writer, object)) writer.text.line("inverse");
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
