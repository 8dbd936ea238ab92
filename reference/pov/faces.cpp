#include "reference/pov/faces.h"

#include <algorithm>

#include "reference/pov/shape_geometry.h"

namespace lancer::reference::pov {

namespace {

/// Whether a direction across one of `a`'s edges separates two faces of one plane, or leaves them
/// only an edge in common.
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
            add_faces(scene, i, most, faces);
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
