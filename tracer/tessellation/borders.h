// Border curves of patches. Two patches with a common border must cut it in the same way.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "model/patch_net.h"

namespace lancer::splines {

/// The control points of a cubic.
using BorderCurve = std::array<Vec3d, 4>;

/// The four sides of a Bezier patch, counter-clockwise in (u, v) from the corner (0, 0).
std::array<BorderCurve, 4> border_curves(const BezierPatch& p);

/// The tolerance of a border curve, for a patch with this tolerance. Without one it is 1/2000 of
/// the diagonal of the box of the curve's own control points.
double border_tolerance(const BorderCurve& c, std::optional<double> tolerance);

/// The share of the tolerance that the chords of a border may use. The rest is for the triangles
/// beside them. With a larger share there would be many triangles, with a smaller one many chords.
inline constexpr double border_share = 0.95;

/// The number of equal parameter steps into which a border curve is cut, so that chords and curve
/// are within border_share of the tolerance of each other. The same for the reversed curve.
int border_steps(const BorderCurve& curve, double tolerance);

/// A fast upper estimate of border_steps(); at most 2^20.
int likely_border_steps(const BorderCurve& curve, double tolerance);

/// For each border curve the smallest tolerance of the patches that have it.
class BorderTolerances {
  public:
    /// Adds the border curves of a patch.
    ///
    /// \param tolerance  the one that tessellate() will get
    void add(const Patch& patch, std::optional<double> tolerance);

    /// The tolerance of this curve, in either direction; nothing if no patch has it.
    std::optional<double> at(const BorderCurve& curve) const;

  private:
    std::map<std::array<double, 12>, double> smallest_;
};

}  // namespace lancer::splines
