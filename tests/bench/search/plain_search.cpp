// The cost of rays without a tree: all triangles, and the grid of the course on which Lancer is
// based.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tests/bench/search/search_rays.h"

namespace lancer::search {

namespace {

/// T. Möller, B. Trumbore, Fast, minimum storage ray/triangle intersection, JGT 2(1), 1997.
double distance_to(const std::array<Vec3d, 3>& corners, const SearchRay& ray) {
    const Vec3d e1 = corners[1] - corners[0];
    const Vec3d e2 = corners[2] - corners[0];
    const Vec3d p = cross(ray.direction, e2);
    const double determinant = dot(e1, p);
    if (determinant == 0) return no_hit;
    const Vec3d s = ray.origin - corners[0];
    const double u = dot(s, p) / determinant;
    if (u < 0 || u > 1) return no_hit;
    const Vec3d q = cross(s, e1);
    const double v = dot(ray.direction, q) / determinant;
    if (v < 0 || u + v > 1) return no_hit;
    const double t = dot(e2, q) / determinant;
    return t > 0 ? t : no_hit;
}

std::vector<std::array<Vec3d, 3>> triangles_of(const Mesh& mesh) {
    std::vector<std::array<Vec3d, 3>> triangles;
    for (const auto& [a, b, c] : mesh.faces)
        triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    return triangles;
}

/// The nearest so far.
struct Nearest {
    double t = no_hit;
    std::uint32_t face = 0;
    void add(double at, std::uint32_t of) {
        if (at < t) t = at, face = of;
    }
};

/// The box around the facets, cut into the cube root of their number of boxes a side; each has the
/// list of the facets whose bounds meet it. J. Amanatides, A. Woo, A fast voxel traversal algorithm
/// for ray tracing, Eurographics 1987.
class Grid {
  public:
    explicit Grid(const Mesh& mesh) : triangles_(triangles_of(mesh)) {
        min_ = max_ = triangles_[0][0];
        for (const auto& triangle : triangles_) {
            for (const Vec3d& corner : triangle) {
                for (int a = 0; a < 3; ++a) {
                    min_[a] = std::min(min_[a], corner[a]);
                    max_[a] = std::max(max_[a], corner[a]);
                }
            }
        }
        side_ = std::max(1, static_cast<int>(std::cbrt(static_cast<double>(triangles_.size()))));
        boxes_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) *
                      static_cast<std::size_t>(side_));
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            std::array<int, 3> low{}, high{};
            for (int a = 0; a < 3; ++a) {
                const auto [least, most] =
                    std::minmax({triangles_[i][0][a], triangles_[i][1][a], triangles_[i][2][a]});
                low[static_cast<std::size_t>(a)] = cell_of(least, a);
                high[static_cast<std::size_t>(a)] = cell_of(most, a);
            }
            for (int z = low[2]; z <= high[2]; ++z)
                for (int y = low[1]; y <= high[1]; ++y)
                    for (int x = low[0]; x <= high[0]; ++x) boxes_[index_of(x, y, z)].push_back(i);
        }
    }

    Nearest nearest(const SearchRay& ray) const {
        double enter = 0;
        double leave = no_hit;
        for (int a = 0; a < 3; ++a) {
            const double t0 = (min_[a] - ray.origin[a]) / ray.direction[a];
            const double t1 = (max_[a] - ray.origin[a]) / ray.direction[a];
            enter = std::max(enter, std::min(t0, t1));
            leave = std::min(leave, std::max(t0, t1));
        }
        Nearest found;
        if (!(enter <= leave)) return found;
        std::array<int, 3> cell{}, step{};
        std::array<double, 3> next{}, width{};
        for (int i = 0; i < 3; ++i) {
            const auto a = static_cast<std::size_t>(i);
            const double size = (max_[i] - min_[i]) / side_;
            cell[a] = cell_of(ray.origin[i] + ray.direction[i] * enter, i);
            step[a] = ray.direction[i] < 0 ? -1 : 1;
            width[a] = size / std::abs(ray.direction[i]);
            const double wall = min_[i] + size * (cell[a] + (step[a] > 0 ? 1 : 0));
            next[a] = (wall - ray.origin[i]) / ray.direction[i];
        }
        for (;;) {
            for (const std::uint32_t i : boxes_[index_of(cell[0], cell[1], cell[2])])
                found.add(distance_to(triangles_[i], ray), i);
            const auto axis =
                static_cast<std::size_t>(std::min_element(next.begin(), next.end()) - next.begin());
            if (found.t <= next[axis]) return found;
            cell[axis] += step[axis];
            if (cell[axis] < 0 || cell[axis] >= side_) return found;
            next[axis] += width[axis];
        }
    }

  private:
    int cell_of(double place, int axis) const {
        const double share = (place - min_[axis]) / (max_[axis] - min_[axis]);
        return std::clamp(static_cast<int>(share * side_), 0, side_ - 1);
    }
    std::size_t index_of(int x, int y, int z) const {
        return static_cast<std::size_t>((z * side_ + y) * side_ + x);
    }

    std::vector<std::array<Vec3d, 3>> triangles_;
    Vec3d min_, max_;
    int side_ = 1;
    std::vector<std::vector<std::uint32_t>> boxes_;
};

template <class Nearest>
Search search_by(Nearest nearest) {
    return [nearest](std::span<const SearchRay> rays, std::span<double> distances,
                     std::span<std::uint32_t> faces) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto found = nearest(rays[i]);
            distances[i] = found.t;
            if (!faces.empty()) faces[i] = found.face;
        }
    };
}

}  // namespace

std::vector<NamedSearch> plain_searches(const Mesh& mesh) {
    const auto grid = std::make_shared<const Grid>(mesh);
    const auto all = std::make_shared<const std::vector<std::array<Vec3d, 3>>>(triangles_of(mesh));
    return {
        {"the course's grid, double",
         search_by([grid](const SearchRay& ray) { return grid->nearest(ray); })},
        {"every triangle, double", search_by([all](const SearchRay& ray) {
             Nearest found;
             for (std::uint32_t i = 0; i < all->size(); ++i)
                 found.add(distance_to((*all)[i], ray), i);
             return found;
         }),
         true},
    };
}

}  // namespace lancer::search
