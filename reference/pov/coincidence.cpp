#include "reference/pov/coincidence.h"

#include <algorithm>
#include <limits>

#include "reference/pov/export_scale.h"

namespace lancer::reference::pov {

namespace {

/// Points p with normal·p = offset, within `bounds`.
struct Face {
    std::uint32_t object;
    Vec3d normal;  ///< unit
    double offset;
    Bounds bounds;
};

/// The flat faces of one object.
struct FaceFinder {
    const Affine<double>& to_world;
    std::uint32_t object;
    std::vector<Face>& out;
    const Scene& scene;

    /// A face given by its corners in the object's own space.
    void polygon(std::initializer_list<Vec3d> corners) const {
        std::vector<Vec3d> p;
        for (const Vec3d& corner : corners) p.push_back(map_point(to_world, corner));
        const Vec3d across = cross(p[1] - p[0], p[2] - p[0]);
        if (!(length(across) > 0)) return;
        Face face{object, normalize(across), 0, {}};
        face.offset = dot(face.normal, p[0]);
        for (const Vec3d& corner : p) face.bounds.add(corner);
        out.push_back(face);
    }
    void rectangle(const Vec3d& corner, const Vec3d& a, const Vec3d& b) const {
        polygon({corner, corner + a, corner + b, corner + a + b});
    }

    void operator()(const Box& box) const {
        const Vec3d d = box.max - box.min;
        const Vec3d x(d.x, 0, 0), y(0, d.y, 0), z(0, 0, d.z);
        for (const auto& [a, b, c] :
             {std::array{x, y, z}, std::array{y, z, x}, std::array{z, x, y}}) {
            rectangle(box.min, a, b);
            rectangle(box.min + c, a, b);
        }
    }
    void disc(const Vec3d& center, const Vec3d& axis, double radius) const {
        if (radius <= 0) return;
        const Vec3d w = normalize(axis);
        const Vec3d u =
            normalize(cross(w, std::abs(w.x) > 0.5 ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0))) * radius;
        const Vec3d v = cross(w, u);
        rectangle(center - u - v, 2.0 * u, 2.0 * v);
    }
    void operator()(const Cylinder& s) const {
        if (!s.capped) return;
        disc(s.base, s.top - s.base, s.radius);
        disc(s.top, s.top - s.base, s.radius);
    }
    void operator()(const Cone& s) const {
        if (!s.capped) return;
        disc(s.base, s.top - s.base, s.base_radius);
        disc(s.top, s.top - s.base, s.top_radius);
    }
    void operator()(const PrismRef& s) const {
        const Prism& prism = scene.prisms[s.prism];
        if (!prism.capped) return;
        const Bounds b = *shape_bounds(scene, s);
        for (const double y : {prism.bottom, prism.top})
            rectangle({b.low.x, y, b.low.z}, {b.high.x - b.low.x, 0, 0},
                      {0, 0, b.high.z - b.low.z});
    }
    void operator()(const Triangle& s) const { polygon({s.points[0], s.points[1], s.points[2]}); }
    void operator()(const Plane& s) const {
        const Vec3d own = normalize(s.normal);
        // A normal moves with the transposed inverse.
        const Vec3d n = normalize(map_transposed(inverse(to_world), own));
        Face face{object, n, dot(n, map_point(to_world, own * s.offset)), {}};
        constexpr double infinity = std::numeric_limits<double>::infinity();
        face.bounds.add(Vec3d(-infinity));
        face.bounds.add(Vec3d(infinity));
        out.push_back(face);
    }
    // Curved, or flat in no way that would be known here.
    void operator()(const Sphere&) const {}
    void operator()(const MeshRef&) const {}
    void operator()(const PatchRef&) const {}
    void operator()(const LatheRef&) const {}
};

bool coincide(const Face& a, const Face& b) {
    const double cosine = dot(a.normal, b.normal);
    if (std::abs(cosine) < 1 - 1e-12 || !a.bounds.overlaps(b.bounds)) return false;
    const double distance = std::abs(a.offset - (cosine > 0 ? b.offset : -b.offset));
    return distance <= 1e-9 * std::max({1e-3, std::abs(a.offset), std::abs(b.offset)});
}

}  // namespace

std::vector<std::uint32_t> coincident_objects(const Scene& scene) {
    std::vector<Face> faces;
    for (std::uint32_t i = 0; i < scene.objects.size() && faces.size() < 2000; ++i) {
        const Object& object = scene.objects[i];
        std::visit(FaceFinder{scene.transforms[object.transform], i, faces, scene}, object.shape);
    }
    std::vector<bool> found(scene.objects.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = i + 1; j < faces.size(); ++j)
            if (faces[i].object != faces[j].object && coincide(faces[i], faces[j]))
                found[faces[i].object] = found[faces[j].object] = true;
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < found.size(); ++i)
        if (found[i]) out.push_back(i);
    return out;
}

}  // namespace lancer::reference::pov
