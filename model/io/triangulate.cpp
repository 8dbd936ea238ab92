// Triangulates faces with more than three corners: as a fan if that is correct, otherwise by ear
// clipping.
//
// G. H. Meisters, Polygons Have Ears, The American Mathematical Monthly 82 (1975): a simple polygon
// always has an ear, a corner that can be cut off along a diagonal inside it. The tests are exact
// (expansion.h) in the projection of the polygon along the largest component of its normal. So an
// ear is always found, and no tolerance is needed.
#include <fmt/format.h>

#include <algorithm>

#include "model/diagnostic.h"
#include "model/io/degenerate.h"
#include "model/io/expansion.h"
#include "model/io/mesh_file.h"

namespace lancer::io {
namespace {

// Clipping compares every pair of corners, so a file must not be able to keep us busy for hours.
constexpr std::size_t most_concave_corners = 10000;

/// Scales the polygon by a power of two to coordinates of at most 2. So the triangles are the same
/// at any scale, and no product overflows or underflows unnecessarily.
std::vector<Vec3d> normalized_polygon(std::span<const Vec3d> vertices,
                                      std::span<const std::uint32_t> corners) {
    double extent = 0;
    for (const std::uint32_t corner : corners) {
        extent = std::max(extent, max_component(absolute(vertices[corner])));
    }
    const int exponent = extent > 0 ? -std::ilogb(extent) : 0;
    std::vector<Vec3d> points;
    points.reserve(corners.size());
    for (const std::uint32_t corner : corners) {
        points.push_back(scaled_by_power_of_two(vertices[corner], exponent));
    }
    return points;
}

/// Newell's method: twice the area vector of a polygon that need not be planar. Computed relative
/// to the first corner, so that a polygon far from the origin loses no precision.
Vec3d area_vector(const std::vector<Vec3d>& points) {
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        sum = sum + cross(points[i] - points[0], points[i + 1] - points[0]);
    }
    return sum;
}

/// Projects the points along the coordinate in which the polygon is flattest, so that it turns
/// left.
std::vector<Vec2d> projected(const std::vector<Vec3d>& points, const Vec3d& normal) {
    const Vec3d size = absolute(normal);
    const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    int first = (drop + 1) % 3;
    int second = (drop + 2) % 3;
    if (normal[drop] < 0) std::swap(first, second);
    std::vector<Vec2d> flat;
    flat.reserve(points.size());
    for (const Vec3d& p : points) flat.emplace_back(p[first], p[second]);
    return flat;
}

class Polygon {
  public:
    explicit Polygon(std::vector<Vec3d> points)
        : points_(std::move(points)), flat_(projected(points_, area_vector(points_))) {}

    /// True when no corner turns right and all triangles (0, i, i + 1) have an area.
    bool is_convex_fan() const {
        const std::size_t n = points_.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (turn(i, (i + 1) % n, (i + 2) % n) < 0) return false;
        }
        for (std::size_t i = 1; i + 1 < n; ++i) {
            if (turn(0, i, i + 1) <= 0 || is_flat(0, i, i + 1)) return false;
        }
        return true;
    }

    void fan(std::vector<Mesh::Corners>& triangles) const {
        for (std::uint32_t i = 1; i + 1 < points_.size(); ++i) triangles.push_back({0, i, i + 1});
    }

    void clip_ears(std::vector<Mesh::Corners>& triangles) {
        make_ring();
        classify();
        std::size_t at = 1;  // so that a convex quadrilateral begins with (0, 1, 2)
        std::size_t tried = 0;
        int repairs = 8;
        while (left_ >= 3) {
            if (is_ear_[at] || tried > left_) {
                emit(previous_[at], at, next_[at], triangles);
                at = cut_off(at);
                classify(previous_[at]);
                classify(at);
                tried = 0;
            } else if (tried == left_ && repairs > 0 && cut_spikes(at)) {
                --repairs;
                classify();
                at = first_;  // this corner may itself have been cut off
                tried = 0;
            } else {
                // A whole round without an ear: the outline touches or crosses itself. Then corners
                // without area are cut off first, and after them any corner, so that the loop
                // always ends.
                ++tried;
                at = next_[at];
            }
        }
    }

  private:
    int turn(std::size_t a, std::size_t b, std::size_t c) const {
        return orientation(flat_[a], flat_[b], flat_[c]);
    }

    bool is_flat(std::size_t a, std::size_t b, std::size_t c) const {
        return is_degenerate(points_[a], points_[b], points_[c]);
    }

    void make_ring() {
        left_ = points_.size();
        next_.resize(left_);
        previous_.resize(left_);
        for (std::size_t i = 0; i < left_; ++i) {
            next_[i] = (i + 1) % left_;
            previous_[i] = (i + left_ - 1) % left_;
        }
    }

    /// Determines again for all corners which are reflex and which are ears.
    void classify() {
        reflex_.clear();
        is_ear_.assign(points_.size(), false);
        const std::size_t start = first_;
        std::size_t i = start;
        do {
            if (turn(previous_[i], i, next_[i]) <= 0) reflex_.push_back(i);
            i = next_[i];
        } while (i != start);
        do {
            classify(i);
            i = next_[i];
        } while (i != start);
    }

    /// Only the two neighbours of a corner that was cut off can change (J. O'Rourke, Computational
    /// Geometry in C, chapter 1), so the total time is quadratic.
    void classify(std::size_t b) {
        const std::size_t a = previous_[b];
        const std::size_t c = next_[b];
        const Vec2d &p = flat_[a], &q = flat_[b], &r = flat_[c];
        const Vec2d low(std::min({p.x, q.x, r.x}), std::min({p.y, q.y, r.y}));
        const Vec2d high(std::max({p.x, q.x, r.x}), std::max({p.y, q.y, r.y}));
        // Most corners are outside the box of the triangle, and this test is faster.
        const auto is_blocked_by = [&](std::size_t corner) {
            const Vec2d& at = flat_[corner];
            return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y &&
                   blocks(corner, a, b, c);
        };
        is_ear_[b] = turn(a, b, c) > 0 && !is_flat(a, b, c) &&
                     std::none_of(reflex_.begin(), reflex_.end(), is_blocked_by);
    }

    bool cut_spikes(std::size_t at) {
        const std::size_t before = left_;
        for (std::size_t i = left_; i > 0 && left_ >= 3; --i) {
            const bool spike =
                turn(previous_[at], at, next_[at]) == 0 || is_flat(previous_[at], at, next_[at]);
            at = spike ? cut_off(at) : next_[at];
        }
        return left_ < before;
    }

    /// Whether corner `p` is in the closed triangle a, b, c and not at one of its corners.
    /// (Outlines that lead to a hole and back pass the same place twice.)
    bool blocks(std::size_t p, std::size_t a, std::size_t b, std::size_t c) const {
        const Vec2d& q = flat_[p];
        if (q == flat_[a] || q == flat_[b] || q == flat_[c]) return false;
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    }

    void emit(std::size_t a, std::size_t b, std::size_t c,
              std::vector<Mesh::Corners>& triangles) const {
        if (is_flat(a, b, c)) return;
        triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                             static_cast<std::uint32_t>(c)});
    }

    /// Removes the corner from the outline and returns where to continue.
    std::size_t cut_off(std::size_t b) {
        const std::size_t a = previous_[b];
        const std::size_t c = next_[b];
        next_[a] = c;
        previous_[c] = a;
        first_ = c;
        --left_;
        // Corners can only become less reflex when a neighbour is removed.
        std::erase_if(reflex_, [&](std::size_t p) {
            return p == b || ((p == a || p == c) && turn(previous_[p], p, next_[p]) > 0);
        });
        return c;
    }

    std::vector<Vec3d> points_;
    std::vector<Vec2d> flat_;
    std::vector<std::size_t> next_;  ///< the remaining outline, as a ring
    std::vector<std::size_t> previous_;
    std::vector<std::size_t> reflex_;  ///< its corners that do not turn left
    std::vector<bool> is_ear_;
    std::size_t first_ = 0;  ///< any corner of it
    std::size_t left_ = 0;   ///< its number of corners
};

}  // namespace

bool triangulate(std::span<const Vec3d> vertices, std::span<const std::uint32_t> corners,
                 std::vector<Mesh::Corners>& triangles) {
    if (corners.size() < 3) return false;
    if (corners.size() == 3) {
        if (is_degenerate(vertices[corners[0]], vertices[corners[1]], vertices[corners[2]])) {
            return false;
        }
        triangles.push_back({0, 1, 2});
        return true;
    }
    const std::size_t before = triangles.size();
    Polygon polygon(normalized_polygon(vertices, corners));
    if (polygon.is_convex_fan()) {
        polygon.fan(triangles);
    } else {
        if (corners.size() > most_concave_corners) {
            throw FileError(
                fmt::format("a face of {} corners that is not convex cannot be split into "
                            "triangles (at most {} corners)",
                            corners.size(), most_concave_corners));
        }
        polygon.clip_ears(triangles);
    }
    return triangles.size() > before;
}

}  // namespace lancer::io
