// Constants that may have any value within wide bounds: no picture depends on them.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace lancer::reference::pov {

/// Values of an image that differ by less are equal except for rounding. POV-Ray's own bound is
/// 1e-7.
inline constexpr double rounding_of_values = 1e-9;

/// POV-Ray treats every fade_power from 1000 on as the Beer-Lambert law.
inline constexpr int beer_lambert = 1001;

/// The direction along which POV-Ray counts surfaces to tell inside from outside. Any direction
/// works that meets no edge.
inline constexpr const char* way_out = "<0.36, 0.48, 0.8>";

/// A number of whole periods, larger than any gradient has on its negative side, plus a billionth,
/// which decides the side for a face exactly on a step.
inline constexpr double periods = 1000000.000000001;

/// The distance from the ends of a cylinder of height 1 within which points belong to its caps:
/// larger than rounding errors.
inline constexpr double cap_margin = 1e-9;

/// The length by which objects move where faces coincide. POV-Ray drops hits nearer than 1e-4 and
/// shadows nearer than 1e-3.
inline constexpr double resolving_step_length = 5e-3;

/// The distance of a parallel light: beyond all objects, within POV-Ray's 1e7.
inline constexpr double far_away = 5e6;

/// The number of halvings of a patch. More are nearer to the true surface, but take more memory.
inline constexpr int most_halvings = 9;
inline constexpr int least_halvings = 3;
/// This many pairs of triangles take about 250 MB.
inline constexpr std::size_t most_pairs = std::size_t(1) << 20;

/// How often POV-Ray halves each patch: as often as all triangles fit into memory.
///
/// \param patches  the number of patches of each net
inline int halvings_for(const std::vector<std::size_t>& patches) {
    std::size_t all = 0;
    for (const std::size_t count : patches) all += count;
    int steps = most_halvings;
    while (steps > least_halvings && (all << (2 * steps)) > most_pairs) --steps;
    return steps;
}

/// A patch's `type`: POV-Ray stores the triangles (1) or makes the same ones again for each ray
/// (0).
inline constexpr int kept_triangles = 1;

/// The number of pieces for each segment of a curved lathe, a power of two. POV-Ray loses roots of
/// long pieces and digits of short ones (docs/export.md, "Curved lathes"); 2 to 8 work equally
/// well.
inline constexpr std::size_t lathe_pieces = 4;

/// The deepest recursion of POV-Ray; it reduces larger values to this.
inline constexpr int most_levels = 256;

/// A mesh with more faces is written in pieces whose size is a few edges. In a knot of 50,000
/// triangles at 1024 x 1024, pieces of up to 8 edges remove all ten wrong pixels.
inline constexpr std::size_t most_faces_of_a_piece = 1000;
inline constexpr double edges_of_a_piece = 4;

/// Meshes are moved by multiples of about their size; the exact step does not matter.
inline double step_for(double size) {
    return size > 0 ? std::ldexp(1.0, std::ilogb(size) + 1) : 1;
}

}  // namespace lancer::reference::pov
