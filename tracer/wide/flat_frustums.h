// Cylinders and cones as plain numbers.
#pragma once

#include "tracer/shapes/frustum_line.h"
#include "tracer/wide/scene.h"

namespace lancer::wide {

Frustum flat_frustum(const FrustumSolid<double>& frustum);

/// A ball that holds the frustum, by a margin: a line that the tests of balls find outside has no
/// crossing with the frustum, however its roundings fall.
///
/// Proof. The radius is larger by a millionth, 2^-20. The roundings of this function are a few u of
/// the place and of the size; `filter_error` covers those of the place. A crossing is computed for
/// a line that passes the frustum by less than 64 u D, where D is the distance of its start plus
/// the frustum's size. BallGuess lets all lines pass whose squared distance from the centre is at
/// most R^2 + 96 u D^2, which is more than (R' + 64 u D)^2 with R' < (1 - 2^-21) R, as 2 * 64 u R'
/// D <= 64 u (R'^2 + D^2). It cuts a chord off by a fiftieth of its half, and only a chord whose
/// half is more than 600 sqrt(u) D, whereas a crossing is known to within 12 sqrt(u) D.
Ball ball_around(const FrustumSolid<double>& frustum);

}  // namespace lancer::wide
