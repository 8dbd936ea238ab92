// A mesh and rays for the searches of bench_search.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "model/shapes.h"

namespace lancer::search {

/// A ray with any origin; `direction` is a unit vector up to rounding.
struct SearchRay {
    Vec3d origin, direction;
};

inline constexpr double no_hit = std::numeric_limits<double>::infinity();

/// A tube about a (2, 3) torus knot: 2 `around` x `across` triangles without normals.
Mesh torus_knot(int around, int across);

/// Rays of a camera with side x side pixels, eight neighbours (4 x 2 pixels) after each other.
std::vector<SearchRay> camera_rays(int side);

/// Rays from the hits of `rays`, a thousandth of the scene off the surface, in directions in which
/// a matt surface scatters light (cosine-weighted).
///
/// \param hits  distances along `rays`; no_hit: none
std::vector<SearchRay> scattered_rays(const Mesh& mesh, std::span<const SearchRay> rays,
                                      std::span<const double> hits,
                                      std::span<const std::uint32_t> faces);

/// Finds for each ray the distance to the nearest triangle, or no_hit; and its index in `faces`,
/// unless that is empty.
using Search = std::function<void(std::span<const SearchRay> rays, std::span<double> distances,
                                  std::span<std::uint32_t> faces)>;

struct NamedSearch {
    const char* name;
    Search search;
    bool is_brute = false;  ///< asks every triangle, so that it can take but a few rays
};

/// The tracer's searches on every level of this processor. The mesh must live as long.
std::vector<NamedSearch> lancer_searches(const Mesh& mesh);
/// Embree's, in float; none where it is not installed.
std::vector<NamedSearch> embree_searches(const Mesh& mesh);
/// Every triangle by every ray, and the course's grid with as many boxes as triangles.
std::vector<NamedSearch> plain_searches(const Mesh& mesh);

}  // namespace lancer::search
