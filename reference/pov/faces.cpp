#include "reference/pov/faces.h"

#include <algorithm>
#include <optional>

#include "model/bodies.h"
#include "model/splines.h"
#include "reference/pov/export_scale.h"

namespace lancer::reference::pov {

namespace {

/// What rounding of the scene's own numbers leaves of a coincidence, of the numbers' size.
constexpr double rounding = 1e-9;

bool equal(double a, double b, double size) {
    return std::abs(a - b) <= rounding * std::max(1e-3, size);
}

/// The factor of a similarity, or nothing: under any other map a circle is no circle.
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

/// Whether a point of a profile's plane lies in the body that the profile bounds.
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
        // A normal moves with the transposed inverse.
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
    void operator()(const PatchRef&) const {}  // flat in no way that would be known here
    void operator()(const Torus&) const {}     // nor this
};

/// Whether a direction across one of `a`'s edges parts two faces of one plane, or leaves them an
/// edge.
bool is_parted(const FlatFace& a, const FlatFace& b) {
    if (a.corners.empty() || b.corners.empty()) return false;
    const Vec3d& first = a.corners[0];
    for (const Vec3d& edge :
         {a.corners[1] - first, a.corners[2] - first, a.corners.back() - a.corners[1]}) {
        const Vec3d across = normalize(cross(a.normal, edge));
        const auto extent = [&](const FlatFace& face) {
            std::pair<double, double> range{dot(across, face.corners[0]), 0};
            range.second = range.first;
            for (const Vec3d& corner : face.corners) {
                range.first = std::min(range.first, dot(across, corner));
                range.second = std::max(range.second, dot(across, corner));
            }
            return range;
        };
        const auto [low_a, high_a] = extent(a);
        const auto [low_b, high_b] = extent(b);
        const double shared = std::min(high_a, high_b) - std::max(low_a, low_b);
        if (shared <= rounding * std::max({1e-3, std::abs(low_a), std::abs(high_a)})) return true;
    }
    return false;
}

struct Coincides {
    bool operator()(const FlatFace& a, const FlatFace& b) const {
        const double cosine = dot(a.normal, b.normal);
        if (std::abs(cosine) < 1 - 1e-12) return false;
        return equal(a.offset, cosine > 0 ? b.offset : -b.offset,
                     std::max(std::abs(a.offset), std::abs(b.offset))) &&
               !is_parted(a, b) && !is_parted(b, a);
    }
    bool operator()(const RoundFace& a, const RoundFace& b) const {
        const double size = std::max({std::abs(a.low), std::abs(a.high), std::abs(b.low),
                                      std::abs(b.high), a.radius, b.radius, length(a.point)});
        if (length(a.axis - b.axis) > rounding || !equal(length(a.point - b.point), 0, size))
            return false;
        const double low = std::max(a.low, b.low);
        const double high = std::min(a.high, b.high);
        return high - low > rounding * size &&
               equal(a.radius + a.slope * low, b.radius + b.slope * low, size) &&
               equal(a.radius + a.slope * high, b.radius + b.slope * high, size);
    }
    bool operator()(const BallFace& a, const BallFace& b) const {
        const double size = a.radius + length(a.center);
        return equal(a.radius, b.radius, size) && equal(length(a.center - b.center), 0, size);
    }
    bool operator()(const auto&, const auto&) const { return false; }
};

struct Reach {
    const Vec3d& center;
    double operator()(const FlatFace& f) const { return f.offset - dot(f.normal, center); }
    double operator()(const RoundFace& f) const {
        const double there = f.radius + f.slope * dot(f.axis, center);
        return there / std::sqrt(1 + f.slope * f.slope);
    }
    double operator()(const BallFace& f) const { return f.radius; }
};

}  // namespace

std::vector<Face> faces_of(const Scene& scene, std::size_t most) {
    std::vector<Face> faces;
    for (const bool meshes : {false, true}) {
        for (std::uint32_t i = 0; i < scene.objects.size() && faces.size() < most; ++i) {
            const Object& object = scene.objects[i];
            if (std::holds_alternative<MeshRef>(object.shape) != meshes) continue;
            std::visit(FaceFinder{scene, scene.transforms[object.transform], i, most, faces},
                       object.shape);
        }
    }
    return faces;
}

bool coincide(const Face& a, const Face& b) {
    return std::visit(Coincides{}, a.form, b.form);
}

bool look_alike(const Face& a, const Face& b) {
    const auto* flat = std::get_if<FlatFace>(&a.form);
    if (flat == nullptr) return a.outward == b.outward;
    return dot(flat->normal, std::get<FlatFace>(b.form).normal) > 0;
}

double reach(const Face& face, const Vec3d& center) {
    return face.outward * std::visit(Reach{center}, face.form);
}

}  // namespace lancer::reference::pov
