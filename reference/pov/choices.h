// Numbers that may be any within wide bounds, each with its bounds: no picture depends on them.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace lancer::reference::pov {

/// Of an image's values: what differs by less came about by rounding. POV-Ray's own is 1e-7.
inline constexpr double rounding_of_values = 1e-9;

/// POV-Ray takes every fade_power from 1000 on for Beer's and Lambert's law.
inline constexpr int beer_lambert = 1001;

/// Along which POV-Ray counts surfaces to tell inside from outside: any way that meets no edge.
inline constexpr const char* way_out = "<0.36, 0.48, 0.8>";

/// Whole periods, more than any gradient has on its negative side, and a billionth, which decides
/// for a face that lies exactly on a step.
inline constexpr double periods = 1000000.000000001;

/// How far from the ends of a cylinder of height 1 its caps begin: more than rounding puts them.
inline constexpr double cap_margin = 1e-9;

/// By which objects move where faces coincide: hits nearer than 1e-4 are dropped, shadows nearer
/// than 1e-3.
inline constexpr double resolving_step_length = 5e-3;

/// The distance of a parallel light: beyond all objects, within POV-Ray's 1e7.
inline constexpr double far_away = 5e6;

/// Halvings of a patch: the more, the nearer to the true surface and the more memory.
inline constexpr int most_halvings = 9;
inline constexpr int least_halvings = 3;
/// Pairs of triangles that take about 250 MB.
inline constexpr std::size_t most_pairs = std::size_t(1) << 20;

/// How often POV-Ray halves each patch: as often as the triangles of all of them fit.
///
/// \param patches  of each net
inline int halvings_for(const std::vector<std::size_t>& patches) {
    std::size_t all = 0;
    for (const std::size_t count : patches) all += count;
    int steps = most_halvings;
    while (steps > least_halvings && (all << (2 * steps)) > most_pairs) --steps;
    return steps;
}

/// A patch's `type`: POV-Ray keeps the triangles (1) or makes the same ones anew for each ray (0).
inline constexpr int kept_triangles = 1;

/// Pieces that each segment of a curved lathe is cut into, a power of two. POV-Ray loses roots of
/// long ones and digits of short ones (docs/export.md, "Curved lathes"): 2 to 8 do alike.
inline constexpr std::size_t lathe_pieces = 4;

/// The most levels that POV-Ray follows: it takes more for as many.
inline constexpr int most_levels = 256;

/// A mesh of more faces is written in pieces of some edges' length: of a knot of 50,000 triangles
/// at 1024 x 1024 none of ten wrong pixels is left with up to 8.
inline constexpr std::size_t most_faces_of_a_piece = 1000;
inline constexpr double edges_of_a_piece = 4;

/// Meshes are moved by whole steps of about their size; any near it will do.
inline double step_for(double size) {
    return size > 0 ? std::ldexp(1.0, std::ilogb(size) + 1) : 1;
}

}  // namespace lancer::reference::pov
