// POV-Ray's own primitive for each shape, and images mapped by the shape's parameters. POV-Ray has
// this mapping for spheres, meshes, patches and lathes, with the same rules. For boxes, cylinders
// and cones it is composed here from the faces.
#include <fmt/format.h>

#include <algorithm>

#include "reference/pov/choices.h"
#include "reference/pov/composites.h"
#include "reference/pov/materials.h"
#include "reference/pov/pigments.h"
#include "reference/pov/shapes.h"

namespace lancer::reference::pov {

namespace {

bool has_uv_image(const Scene& scene, const Object& object) {
    const Texture* texture = texture_of(scene, scene.materials[object.material]);
    const auto* image = texture == nullptr ? nullptr : std::get_if<ImageTexture>(&texture->pattern);
    return image != nullptr && image->mapping == ImageTexture::Mapping::uv;
}

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
        // POV-Ray itself turns a cone with equal radii into a cylinder; writing the cylinder avoids
        // questions.
        if (s.base_radius == s.top_radius)
            return (*this)(Cylinder{s.base, s.top, s.base_radius, s.capped});
        return open("cone { " + vector(own(s.base)) + ", " + number(own(s.base_radius)) + ", " +
                    vector(own(s.top)) + ", " + number(own(s.top_radius)) +
                    (s.capped ? "" : " open"));
    }
    /// Uses Sturm's method: the default one misses roots of the quartic.
    bool operator()(const Torus& s) const {
        open("torus { " + number(own(s.radius)) + ", " + number(own(s.tube)) + " sturm");
        // POV-Ray's u begins on the other side and runs the other way: the mirrored torus has ours.
        if (has_uv_image(writer.scene, object)) writer.text.line("scale <-1, 1, 1>");
        return true;
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
    bool operator()(const CompositeRef& s) const {
        open_composite(writer, writer.scene.composites[s.composite]);
        return true;
    }
};

Affine<double> map_of(const Vec3d& u, const Vec3d& v, const Vec3d& w, const Vec3d& shift) {
    return {{Vec3d(u.x, v.x, w.x), Vec3d(u.y, v.y, w.y), Vec3d(u.z, v.z, w.z)}, shift};
}

/// The effect of a texture's transforms on points (u, v, 0). POV-Ray sometimes has another third
/// coordinate, which must be ignored.
Affine<double> within_plane(const Affine<double>& to_object) {
    Affine<long double> back = inverse(convert<long double>(to_object));
    back.rows[0].z = back.rows[1].z = 0;
    return convert<double>(inverse(back));
}

struct UvWriter {
    Writer& writer;
    const Material& material;
    const ImageTexture& image;
    const Affine<double> to_object;  ///< moves the pattern in the plane of u and v
    const Object& object;
    PowerOfTen own;

    std::string picture() const {
        return image_map(writer, material, image, "map_type 0", object.place);
    }
    void line(const std::string& words) const {
        if (!words.empty()) writer.text.line(words);
    }

    /// POV-Ray's own mapping: the pattern point is (u, v, 0).
    void native() const {
        writer.text.open("pigment {");
        line("uv_mapping " + picture());
        line(transform(to_object));
        writer.text.close();
    }
    void planar() const {
        writer.text.open("pigment {");
        line(picture());
        line(pattern_transform(to_object, own));
        writer.text.close();
    }
    /// Writes face `number` of up to eight in the pigment_map: (0, 0) of the image is at `corner`,
    /// u and v run along the two edges. (Points off the face are not visible.)
    void face(int number, const Vec3d& corner, const Vec3d& u, const Vec3d& v) const {
        open_face(number);
        line(picture());
        line(transform(to_object));
        line(transform(map_of(u, v, cross(u, v), corner)));
        writer.text.close("]");
    }
    void open_face(int number) const { writer.text.open("[" + pov::number(number / 8.0)); }

    void operator()(const CompositeRef&) const {}  // the texture belongs to its leaves
    void operator()(const Sphere&) const { native(); }
    void operator()(const Torus&) const { native(); }  // ShapeOpener turns it
    void operator()(const Plane&) const { planar(); }
    void operator()(const Triangle& shape) const {
        const bool mapped = shape.attributes != none &&
                            writer.scene.triangle_attributes[shape.attributes].uvs.has_value();
        mapped ? native() : planar();
    }
    void operator()(const MeshRef& shape) const {
        const Mesh& mesh = *writer.scene.meshes[shape.mesh];
        if (mesh.uvs.empty()) {
            planar();
            return;
        }
        if (!is_mapped(mesh))
            writer.refuse(object.place, "some faces of this mesh have no uvs",
                          "give uvs to all of its faces, or to none");
        native();
    }
    void operator()(const PatchRef&) const { native(); }
    void operator()(const LatheRef&) const { native(); }
    void operator()(const PrismRef&) const {
        writer.refuse(object.place, "POV-Ray has no uv mapping for prisms",
                      "use 'mapping planar' or 'mapping cylindrical'");
    }

    /// Six faces in a cube from -1 to 1, distinguished by their largest coordinate.
    void operator()(const Box& box) const {
        const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
        const auto side = [this](int number, const Vec3d& u, const Vec3d& v, const Vec3d& outward) {
            face(number, outward - u - v, 2.0 * u, 2.0 * v);
        };
        writer.text.open("pigment {  // the faces -x, +x, -y, +y, -z, +z: see the function");
        line("function { select(max(abs(y), abs(z)) - abs(x), select(x, 0, 1),");
        line("           select(abs(z) - abs(y), select(y, 2, 3), select(z, 4, 5))) / 8 }");
        writer.text.open("pigment_map {");
        side(0, z, y, -x);
        side(1, -z, y, x);
        side(2, x, z, -y);
        side(3, x, -z, y);
        side(4, -x, y, -z);
        side(5, x, y, z);
        writer.text.close();
        const Vec3d low = own(box.min);
        const Vec3d high = own(box.max);
        const Vec3d half = (high - low) / 2.0;
        if (half.x * half.y * half.z == 0)
            writer.refuse(object.place, "POV-Ray cannot tell the sides of a flat box apart",
                          "give the box some thickness");
        line(transform(map_of({half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}, (low + high) / 2.0)));
        writer.text.close();
    }

    void operator()(const Cylinder& s) const { round(s.base, s.top, s.radius, s.radius, s.capped); }
    void operator()(const Cone& s) const {
        round(s.base, s.top, s.base_radius, s.top_radius, s.capped);
    }

    /// Base, side and top in a frame whose y runs from 0 at the base to 1 at the top.
    void round(const Vec3d& base, const Vec3d& top, double base_radius, double top_radius,
               bool capped) const {
        const Vec3d axis = own(top) - own(base);
        const Vec3d y = normalize(axis);
        // The world's x axis made perpendicular to y, or the z axis if x is too close to y.
        const int aside = std::abs(y.x) > 0.9 ? 2 : 0;
        Vec3d x = -y[aside] * y;
        x[aside] += 1;
        x = normalize(x);
        const Vec3d z = cross(x, y);
        const auto cap = [this](int number, double radius) {
            const double r = own(radius);
            // The height does not matter: the mapping ignores it.
            if (r != 0) face(number, Vec3d(-r), {2 * r, 0, 0}, {0, 0, 2 * r});
        };
        writer.text.open("pigment {");
        if (capped) {
            // The caps lie at 0 and 1, except for rounding.
            line(fmt::format("function {{ select(y - {0}, 0, select(y - (1 - {0}), 1, 2)) / 8 }}",
                             number(cap_margin)));
            writer.text.open("pigment_map {");
            cap(0, base_radius);
            open_face(1);
            mantle();
            writer.text.close("]");
            cap(2, top_radius);
            writer.text.close();
        } else {
            mantle();
        }
        line(transform(map_of(x, axis, z, own(base))));
        writer.text.close();
    }

    /// The plane of u and v wrapped around: x becomes the angle in turns, y is unchanged.
    void mantle() const {
        line(picture());
        line(transform(to_object));
        line("warp { cylindrical orientation z dist_exp 0 }");
    }
};

}  // namespace

bool open_shape(Writer& writer, const Object& object, PowerOfTen own) {
    return std::visit(ShapeOpener{writer, object, own}, object.shape);
}

void write_uv_pigment(Writer& writer, const Material& material, const ImageTexture& image,
                      const Affine<double>& to_object, const Object& object, PowerOfTen own) {
    std::visit(UvWriter{writer, material, image, within_plane(to_object), object, own},
               object.shape);
}

}  // namespace lancer::reference::pov
