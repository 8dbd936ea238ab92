// Border curves of patches: two patches that have one in common must cut it alike.
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

/// How exactly a border is drawn for a patch of this tolerance; without one, 1/2000 of the diagonal
/// of the curve's own control points' box.
double border_tolerance(const BorderCurve& c, std::optional<double> tolerance);

/// What the chords of a border may take of its tolerance. The rest is for the triangles beside
/// them: with less they get many, and the chords with more.
inline constexpr double border_share = 0.95;

/// Steps of equal parameter into which a border curve is cut, so that chords and curve are within
/// border_share of the tolerance of each other. The same for the reversed curve.
int border_steps(const BorderCurve& curve, double tolerance);

/// At least about as many, quickly. No more than 2^20.
int likely_border_steps(const BorderCurve& curve, double tolerance);

/// The smallest tolerance that any of several patches asks for along a border curve.
class BorderTolerances {
  public:
    /// With the tolerance that tessellate() will get.
    void add(const Patch& patch, std::optional<double> tolerance);

    /// Of this curve, in either direction; none when no patch has it.
    std::optional<double> at(const BorderCurve& curve) const;

  private:
    std::map<std::array<double, 12>, double> smallest_;
};

}  // namespace lancer::splines
