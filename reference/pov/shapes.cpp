#include "reference/pov/shapes.h"

#include <fmt/format.h>

#include "model/bodies.h"
#include "reference/pov/materials.h"

namespace lancer::reference::pov {

namespace {

struct ShapeOpener {
    Writer& writer;
    const Object& object;
    PowerOfTen own;

    bool open(const std::string& words) const {
        writer.text.open(words);
        return true;
    }
    bool operator()(const Sphere& s) const {
        return open("sphere { " + vector(own(s.center)) + ", " + number(own(s.radius)));
    }
    bool operator()(const Box& s) const {
        return open("box { " + vector(own(s.min)) + ", " + vector(own(s.max)));
    }
    bool operator()(const Cylinder& s) const {
        return open("cylinder { " + vector(own(s.base)) + ", " + vector(own(s.top)) + ", " +
                    number(own(s.radius)) + (s.capped ? "" : " open"));
    }
    bool operator()(const Cone& s) const {
        // POV-Ray turns a cone of equal radii into a cylinder itself; said here, nobody wonders.
        if (s.base_radius == s.top_radius)
            return (*this)(Cylinder{s.base, s.top, s.base_radius, s.capped});
        return open("cone { " + vector(own(s.base)) + ", " + number(own(s.base_radius)) + ", " +
                    vector(own(s.top)) + ", " + number(own(s.top_radius)) +
                    (s.capped ? "" : " open"));
    }
    bool operator()(const Plane& s) const {
        return open("plane { " + vector(s.normal) + ", " + number(own(s.offset)));
    }
    bool operator()(const Triangle& s) const { return open_triangle(writer, object, s, own); }
    bool operator()(const MeshRef& s) const { return open_mesh(writer, object, s, own); }
    bool operator()(const PatchRef& s) const {
        return open_patch(writer, object, writer.scene.patches[s.patch], own);
    }
    bool operator()(const LatheRef& s) const {
        return open_lathe(writer, writer.scene.lathes[s.lathe], own);
    }
    bool operator()(const PrismRef& s) const {
        return open_prism(writer, writer.scene.prisms[s.prism], own);
    }
};

}  // namespace

bool open_shape(Writer& writer, const Object& object, PowerOfTen own) {
    return std::visit(ShapeOpener{writer, object, own}, object.shape);
}

void write_object(Writer& writer, std::uint32_t index) {
    const Scene& scene = writer.scene;
    const Object& object = scene.objects[index];
    const Material& material = scene.materials[object.material];
    if (material.phong_transmission > 0) {
        writer.refuse(object.place, "POV-Ray has no highlight of light from behind",
                      "leave 'phong_transmission' out of the material to export the scene");
        return;
    }
    const ObjectSpace space = object_space(scene.transforms[object.transform], writer.scale);
    declare_mesh(writer, object, space.own);
    if (object.name != none) writer.text.line("// \"" + comment(scene.names[object.name]) + "\"");
    if (!open_shape(writer, object, space.own)) return;
    write_texture(writer, object, space.own);  // before the transform, which takes it along
    write_interior(writer, material, is_body(scene, object.shape));
    const std::string moved = transform(space.to_picture);
    if (!moved.empty()) writer.text.line(moved);
    if (!object.casts_shadow || !scene.settings.shadows) writer.text.line("no_shadow");
    writer.text.close();
}

}  // namespace lancer::reference::pov
