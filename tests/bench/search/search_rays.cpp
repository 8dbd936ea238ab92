#include "tests/bench/search/search_rays.h"

#include <cmath>
#include <numbers>
#include <random>

namespace lancer::search {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

Vec3d knot_point(double t) {
    const double r = (2 + std::cos(3 * t)) / 3;
    return {r * std::cos(2 * t), r * std::sin(2 * t), std::sin(3 * t) / 3};
}

}  // namespace

Mesh torus_knot(int around, int across) {
    Mesh mesh;
    for (int i = 0; i < around; ++i) {
        const double t = two_pi * i / around;
        const Vec3d here = knot_point(t);
        const Vec3d along = normalize(knot_point(t + 1e-4) - knot_point(t - 1e-4));
        const Vec3d side = normalize(cross(along, here));
        const Vec3d up = cross(side, along);
        for (int k = 0; k < across; ++k) {
            const double a = two_pi * k / across;
            mesh.vertices.push_back(here + (side * std::cos(a) + up * std::sin(a)) * 0.16);
            const auto index = [&](int row, int column) {
                return static_cast<std::uint32_t>(row % around * across + column % across);
            };
            mesh.faces.push_back({index(i, k), index(i + 1, k), index(i + 1, k + 1)});
            mesh.faces.push_back({index(i, k), index(i + 1, k + 1), index(i, k + 1)});
        }
    }
    return mesh;
}

std::vector<SearchRay> camera_rays(int side) {
    const Vec3d from(2.1, 1.3, 1.7);
    const Vec3d forward = normalize(-from);
    const Vec3d right = normalize(cross(forward, Vec3d(0, 0, 1)));
    const Vec3d up = cross(right, forward);
    const double width = 2 * std::tan(0.5 * 45 * std::numbers::pi / 180);
    std::vector<SearchRay> rays;
    for (int y = 0; y + 1 < side; y += 2) {
        for (int x = 0; x + 3 < side; x += 4) {
            for (int i = 0; i < 8; ++i) {
                const double sx = (x + i % 4 + 0.5) / side - 0.5;
                const double sy = 0.5 - (y + i / 4 + 0.5) / side;
                rays.push_back({from, normalize(forward + (right * sx + up * sy) * width)});
            }
        }
    }
    return rays;
}

std::vector<SearchRay> scattered_rays(const Mesh& mesh, std::span<const SearchRay> rays,
                                      std::span<const double> hits,
                                      std::span<const std::uint32_t> faces) {
    std::mt19937 random(1);
    const auto unit = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
    std::vector<SearchRay> scattered;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i] == no_hit) continue;
        const auto& [a, b, c] = mesh.faces[faces[i]];
        const Vec3d corner = mesh.vertices[a];
        Vec3d normal = normalize(cross(mesh.vertices[b] - corner, mesh.vertices[c] - corner));
        if (dot(normal, rays[i].direction) > 0) normal = -normal;
        const double z = 1 - 2 * unit();  // a point of the unit ball's surface beyond the normal
        const double turn = two_pi * unit();
        const double r = std::sqrt(1 - z * z);
        const Vec3d direction = normal + Vec3d(r * std::cos(turn), r * std::sin(turn), z);
        scattered.push_back(
            {rays[i].origin + rays[i].direction * hits[i] + normal * 1e-3, normalize(direction)});
    }
    return scattered;
}

}  // namespace lancer::search
