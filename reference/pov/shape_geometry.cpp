// The box and the faces of a shape, for the exporter alone. It shares no arithmetic with the
// tracer.
#include "reference/pov/shape_geometry.h"

#include <algorithm>
#include <optional>

#include "model/splines.h"
#include "reference/pov/composites.h"
#include "reference/pov/export_scale.h"

namespace lancer::reference::pov {

namespace {

// The box of a disc of radius r is at most that of a sphere; this is accurate enough for sizes.
void add_ball(Bounds& bounds, const Vec3d& center, double radius) {
    bounds.add(center - Vec3d(radius));
    bounds.add(center + Vec3d(radius));
}

struct OwnBounds {
    const Scene& scene;
    Bounds operator()(const Sphere& s) const {
        Bounds b;
        add_ball(b, s.center, s.radius);
        return b;
    }
    Bounds operator()(const Box& s) const {
        Bounds b;
        b.add(s.min);
        b.add(s.max);
        return b;
    }
    Bounds operator()(const Cylinder& s) const {
        Bounds b;
        add_ball(b, s.base, s.radius);
        add_ball(b, s.top, s.radius);
        return b;
    }
    Bounds operator()(const Cone& s) const {
        Bounds b;
        add_ball(b, s.base, s.base_radius);
        add_ball(b, s.top, s.top_radius);
        return b;
    }
    Bounds operator()(const Torus& s) const {
        const Vec3d reach(s.radius + s.tube, s.tube, s.radius + s.tube);
        Bounds b;
        b.add(-reach);
        b.add(reach);
        return b;
    }
    Bounds operator()(const Plane&) const { return {}; }
    Bounds operator()(const Triangle& s) const {
        Bounds b;
        for (const Vec3d& p : s.points) b.add(p);
        return b;
    }
    Bounds operator()(const MeshRef& s) const {
        Bounds b;
        const Mesh& mesh = *scene.meshes[s.mesh];
        for (const Mesh::Corners& face : mesh.faces)
            for (const std::uint32_t corner : face) b.add(mesh.vertices[corner]);
        return b;
    }
    Bounds operator()(const PatchRef& s) const {
        Bounds b;
        for (const Vec3d& p : scene.patches[s.patch].control) b.add(p);
        return b;
    }
    Bounds operator()(const LatheRef& s) const {
        Bounds b;
        for (const Vec2d& p : scene.lathes[s.lathe].profile) {
            const double r = std::abs(p.x);
            b.add(Vec3d(-r, p.y, -r));
            b.add(Vec3d(r, p.y, r));
        }
        return b;
    }
    Bounds operator()(const PrismRef& s) const {
        Bounds b;
        const Prism& prism = scene.prisms[s.prism];
        for (const Vec2d& p : prism.outline) {
            b.add(Vec3d(p.x, prism.bottom, p.y));
            b.add(Vec3d(p.x, prism.top, p.y));
        }
        return b;
    }
    Bounds operator()(const CompositeRef& s) const {
        return composite_bounds(scene, scene.composites[s.composite]);
    }
};

/// The factor of a similarity; nothing for other maps, under which a circle is no longer a circle.
std::optional<double> similarity(const Affine<double>& map) {
    const Vec3d x = map_vector(map, Vec3d(1, 0, 0));
    const Vec3d y = map_vector(map, Vec3d(0, 1, 0));
    const Vec3d z = map_vector(map, Vec3d(0, 0, 1));
    const double s = length(x);
    const bool even = equal(length(y), s, s) && equal(length(z), s, s);
    const bool right =
        std::abs(dot(x, y)) + std::abs(dot(y, z)) + std::abs(dot(z, x)) <= 4 * rounding * s * s;
    if (!even || !right) return std::nullopt;
    return s;
}

/// Whether a point of a profile's plane lies inside the profile.
bool is_within(const std::vector<Vec2d>& profile, const Vec2d& p) {
    bool inside = false;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Vec2d a = profile[i];
        const Vec2d b = profile[(i + 1) % profile.size()];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

/// The faces of one object.
struct FaceFinder {
    const Scene& scene;
    const Affine<double>& to_world;
    std::uint32_t object;
    std::size_t most;
    std::vector<Face>& out;

    void add_flat(const Vec3d& outwards, std::initializer_list<Vec3d> corners,
                  std::uint32_t index = none) const {
        std::vector<Vec3d> p;
        for (const Vec3d& corner : corners) p.push_back(map_point(to_world, corner));
        const Vec3d across = cross(p[1] - p[0], p[2] - p[0]);
        if (!(length(across) > 0)) return;
        FlatFace face{normalize(across), 0, {}};
        // Normals are transformed by the transposed inverse.
        if (dot(face.normal, map_transposed(inverse(to_world), outwards)) < 0)
            face.normal = -face.normal;
        face.offset = dot(face.normal, p[0]);
        face.corners = std::move(p);
        out.push_back({object, face, 1, none, index});
    }
    void rectangle(const Vec3d& outwards, const Vec3d& corner, const Vec3d& a, const Vec3d& b,
                   std::uint32_t index = none) const {
        add_flat(outwards, {corner, corner + a, corner + b, corner + a + b}, index);
    }
    void disc(const Vec3d& center, const Vec3d& outwards, double radius,
              std::uint32_t index = none) const {
        if (radius <= 0) return;
        const Vec3d w = normalize(outwards);
        const Vec3d u =
            normalize(cross(w, std::abs(w.x) > 0.5 ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0))) * radius;
        const Vec3d v = cross(w, u);
        rectangle(outwards, center - u - v, 2.0 * u, 2.0 * v, index);
    }
    void side(const Vec3d& base, const Vec3d& top, double base_radius, double top_radius,
              int outward, std::uint32_t index = none) const {
        const std::optional<double> factor = similarity(to_world);
        if (!factor) return;
        const Vec3d from = map_point(to_world, base);
        const Vec3d to = map_point(to_world, top);
        RoundFace face;
        face.axis = normalize(to - from);
        for (int i = 0; i < 3; ++i) {
            if (std::abs(face.axis[i]) < 1e-12) continue;
            if (face.axis[i] < 0) face.axis = -face.axis;
            break;
        }
        face.point = from - dot(from, face.axis) * face.axis;
        const double first = dot(from, face.axis);
        const double second = dot(to, face.axis);
        face.slope = *factor * (top_radius - base_radius) / (second - first);
        face.radius = *factor * base_radius - face.slope * first;
        face.low = std::min(first, second);
        face.high = std::max(first, second);
        out.push_back({object, face, outward, none, index});
    }

    void operator()(const Box& box) const {
        const Vec3d d = box.max - box.min;
        const std::array edges{Vec3d(d.x, 0, 0), Vec3d(0, d.y, 0), Vec3d(0, 0, d.z)};
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const Vec3d& across = edges[axis];
            const Vec3d& a = edges[(axis + 1) % 3];
            const Vec3d& b = edges[(axis + 2) % 3];
            rectangle(-across, box.min, a, b, 2 * axis);
            rectangle(across, box.min + across, a, b, 2 * axis + 1);
        }
    }
    void operator()(const Cylinder& s) const {
        (*this)(Cone{s.base, s.top, s.radius, s.radius, s.capped});
    }
    void operator()(const Cone& s) const {
        side(s.base, s.top, s.base_radius, s.top_radius, 1, s.capped ? 0 : none);
        if (!s.capped) return;
        disc(s.base, s.base - s.top, s.base_radius, 1);
        disc(s.top, s.top - s.base, s.top_radius, 2);
    }
    void operator()(const Sphere& s) const {
        const std::optional<double> factor = similarity(to_world);
        if (factor)
            out.push_back(
                {object, BallFace{map_point(to_world, s.center), *factor * s.radius}, 1, none});
    }
    void operator()(const PrismRef& s) const {
        const Prism& prism = scene.prisms[s.prism];
        const Bounds b = *shape_bounds(scene, s);
        if (prism.capped) {
            for (const double y : {prism.bottom, prism.top})
                rectangle({0, y == prism.top ? 1.0 : -1.0, 0}, {b.low.x, y, b.low.z},
                          {b.high.x - b.low.x, 0, 0}, {0, 0, b.high.z - b.low.z});
        }
        if (prism.spline != Spline::linear) return;
        for (std::size_t i = 0; i < prism.outline.size(); ++i) {
            const Vec2d p = prism.outline[i];
            const Vec2d q = prism.outline[(i + 1) % prism.outline.size()];
            const Vec2d middle = 0.5 * (p + q);
            Vec2d outwards(q.y - p.y, p.x - q.x);
            if (is_within(prism.outline, middle + 1e-6 * outwards)) outwards = -1.0 * outwards;
            rectangle({outwards.x, 0, outwards.y}, {p.x, prism.bottom, p.y},
                      {q.x - p.x, 0, q.y - p.y}, {0, prism.top - prism.bottom, 0});
        }
    }
    void operator()(const CompositeRef& s) const {
        const Composite& composite = scene.composites[s.composite];
        for (std::uint32_t i = 0; i < composite.leaves.size() && out.size() < most; ++i) {
            const Composite::Leaf& leaf = composite.leaves[i];
            const std::size_t first = out.size();
            std::visit(
                FaceFinder{scene, scene.transforms[leaf.object.transform], object, most, out},
                leaf.object.shape);
            for (std::size_t k = first; k < out.size(); ++k) out[k].part = i;
        }
    }
    void operator()(const LatheRef& s) const {
        const Lathe& lathe = scene.lathes[s.lathe];
        const PlaneCurve curve = profile_curve(lathe.spline, lathe.profile);
        for (std::size_t i = 0; i < curve.segments(); ++i) {
            const auto piece = curve.segment(i);
            const Vec2d p = piece.front();
            const Vec2d q = piece.back();
            const Vec2d way = q - p;
            const double size = std::max(std::abs(way.x), std::abs(way.y));
            const bool straight = std::all_of(piece.begin(), piece.end(), [&](const Vec2d& c) {
                return std::abs((c.x - p.x) * way.y - (c.y - p.y) * way.x) <=
                       rounding * size * size;
            });
            if (!straight || !(size > 0)) continue;
            Vec2d outwards(way.y, -way.x);
            if (is_within(curve.points, 0.5 * (p + q) + 1e-6 * outwards))
                outwards = -1.0 * outwards;
            if (std::abs(way.y) <= rounding * size)
                disc({0, p.y, 0}, {0, outwards.y, 0}, std::max(p.x, q.x));
            else
                side({0, p.y, 0}, {0, q.y, 0}, p.x, q.x, outwards.x > 0 ? 1 : -1);
        }
    }
    void operator()(const Triangle& s) const {
        const auto& p = s.points;
        add_flat(cross(p[1] - p[0], p[2] - p[0]), {p[0], p[1], p[2]});
    }
    void operator()(const MeshRef& s) const {
        const Mesh& mesh = *scene.meshes[s.mesh];
        double volume = 0;
        const auto corner = [&](const Mesh::Corners& face, std::size_t i) {
            return mesh.vertices[face[i]];
        };
        for (const Mesh::Corners& f : mesh.faces)
            volume += dot(corner(f, 0), cross(corner(f, 1), corner(f, 2)));
        for (const Mesh::Corners& f : mesh.faces) {
            if (out.size() >= most) return;
            const Vec3d across = cross(corner(f, 1) - corner(f, 0), corner(f, 2) - corner(f, 0));
            add_flat(volume < 0 ? -across : across, {corner(f, 0), corner(f, 1), corner(f, 2)});
        }
    }
    void operator()(const Plane& s) const {
        const Vec3d own = normalize(s.normal);
        const Vec3d n = normalize(map_transposed(inverse(to_world), own));
        out.push_back({object, FlatFace{n, dot(n, map_point(to_world, own * s.offset)), {}}});
    }
    void operator()(const PatchRef&) const {}  // its flat parts are not found here
    void operator()(const Torus&) const {}     // it has no flat part
};

}  // namespace

std::optional<Bounds> shape_bounds(const Scene& scene, const Shape& shape) {
    const Bounds bounds = std::visit(OwnBounds{scene}, shape);
    if (bounds.empty) return std::nullopt;
    return bounds;
}

void add_faces(const Scene& scene, std::uint32_t object, std::size_t most, std::vector<Face>& out) {
    const Object& o = scene.objects[object];
    std::visit(FaceFinder{scene, scene.transforms[o.transform], object, most, out}, o.shape);
}

}  // namespace lancer::reference::pov
