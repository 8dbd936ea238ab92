// Images mapped by the shape's own parameters. POV-Ray knows these for spheres, meshes, patches and
// lathes, by the same rules; for boxes, cylinders and cones they are put together here from the
// faces.
#include <fmt/format.h>

#include <algorithm>

#include "reference/pov/pigments.h"

namespace lancer::reference::pov {

namespace {

Affine<double> map_of(const Vec3d& u, const Vec3d& v, const Vec3d& w, const Vec3d& shift) {
    return {{Vec3d(u.x, v.x, w.x), Vec3d(u.y, v.y, w.y), Vec3d(u.z, v.z, w.z)}, shift};
}

struct UvWriter {
    Writer& writer;
    const Material& material;
    const ImageTexture& image;
    const Affine<double>& to_object;  ///< moves the pattern in the plane of u and v
    const Object& object;
    PowerOfTen own;

    std::string picture() const {
        return image_map(writer, material, image, "map_type 0", object.place);
    }
    void line(const std::string& words) const {
        if (!words.empty()) writer.text.line(words);
    }

    /// POV-Ray's own: the pattern point is (u, v, 0).
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
    /// One face of several: `face` takes (u, v, 0) to its place.
    void entry(double at, const Affine<double>& face) const {
        writer.text.open("[" + number(at) + " " + picture());
        line(transform(to_object));
        line(transform(face));
        writer.text.close("]");
    }

    void operator()(const Sphere&) const { native(); }
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
        const auto lacks_uv = [](const Mesh::Corners& corners) {
            return std::find(corners.begin(), corners.end(), none) != corners.end();
        };
        if (std::any_of(mesh.uv_faces.begin(), mesh.uv_faces.end(), lacks_uv))
            writer.refuse(object.place, "some faces of this mesh have no uvs",
                          "give all of them uvs, or none");
        native();
    }
    void operator()(const PatchRef&) const { native(); }
    void operator()(const LatheRef&) const { native(); }
    void operator()(const PrismRef&) const {
        writer.refuse(object.place, "POV-Ray has no uv mapping for prisms",
                      "use 'mapping planar' or 'mapping cylindrical'");
    }

    /// Six faces in a cube from -1 to 1, told apart by their largest coordinate.
    void operator()(const Box& box) const {
        const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
        const auto face = [](const Vec3d& u, const Vec3d& v, const Vec3d& w) {
            return map_of(2.0 * u, 2.0 * v, w, w - u - v);
        };
        writer.text.open("pigment {  // the faces -x, +x, -y, +y, -z, +z: see the function");
        line("function { select(max(abs(y), abs(z)) - abs(x), select(x, 0, 1),");
        line("           select(abs(z) - abs(y), select(y, 2, 3), select(z, 4, 5))) / 8 }");
        writer.text.open("pigment_map {");
        entry(0.0 / 8, face(z, y, -x));
        entry(1.0 / 8, face(-z, y, x));
        entry(2.0 / 8, face(x, z, -y));
        entry(3.0 / 8, face(x, -z, y));
        entry(4.0 / 8, face(-x, y, -z));
        entry(5.0 / 8, face(x, y, z));
        writer.text.close();
        const Vec3d low = own(box.min);
        const Vec3d high = own(box.max);
        Vec3d half = (high - low) / 2.0;
        for (double* side : {&half.x, &half.y, &half.z})
            if (*side == 0) *side = 1;  // a flat box shows nothing of these faces
        line(transform(map_of({half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}, (low + high) / 2.0)));
        writer.text.close();
    }

    void operator()(const Cylinder& s) const { round(s.base, s.top, s.radius, s.radius, s.capped); }
    void operator()(const Cone& s) const {
        round(s.base, s.top, s.base_radius, s.top_radius, s.capped);
    }

    /// Base, mantle and top in a frame whose y runs from 0 at the base to 1 at the top.
    void round(const Vec3d& base, const Vec3d& top, double base_radius, double top_radius,
               bool capped) const {
        const Vec3d axis = own(top) - own(base);
        const Vec3d y = normalize(axis);
        const Vec3d reference = std::abs(y.x) > 0.9 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
        const Vec3d x = normalize(reference - dot(reference, y) * y);
        const Vec3d z = cross(x, y);
        const auto cap = [this](double radius, double height) {
            const double r = own(radius > 0 ? radius : 1);
            return map_of({2 * r, 0, 0}, {0, 0, 2 * r}, {0, 1, 0}, {-r, height, -r});
        };
        writer.text.open("pigment {");
        if (capped) {
            // The caps lie at 0 and 1 but for rounding.
            line("function { select(y - 1e-9, 0, select(y - (1 - 1e-9), 1, 2)) / 4 }");
            writer.text.open("pigment_map {");
            entry(0.0 / 4, cap(base_radius, 0));
            writer.text.open("[" + number(1.0 / 4));
            mantle();
            writer.text.close("]");
            entry(2.0 / 4, cap(top_radius, 1));
            writer.text.close();
        } else {
            mantle();
        }
        line(transform(map_of(x, axis, z, own(base))));
        writer.text.close();
    }

    /// The plane of u and v rolled up: x becomes the angle in turns, y stays.
    void mantle() const {
        line(picture());
        line(transform(to_object));
        line("warp { cylindrical orientation z dist_exp 0 }");
    }
};

}  // namespace

void write_uv_pigment(Writer& writer, const Material& material, const ImageTexture& image,
                      const Affine<double>& to_object, const Object& object, PowerOfTen own) {
    std::visit(UvWriter{writer, material, image, to_object, object, own}, object.shape);
}

}  // namespace lancer::reference::pov
