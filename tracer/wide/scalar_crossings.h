// The exact crossings of one ray with one item: two of ExactMethods.
#pragma once

#include "tracer/scene/geometry.h"
#include "tracer/wide/scalar_rays.h"

namespace lancer::wide {

/// See ExactMethods::crossings.
///
/// \param listed  whether bodies around rays are listed: start.bodies counts
void cross_item(const Geometry<double>& geometry, std::uint32_t item, const LaneRay& ray,
                const LaneStart& start, bool listed, const HitSink& sink);

/// See ExactMethods::blocks.
bool blocks_light(const Geometry<double>& geometry, std::uint32_t item, const LaneRay& ray,
                  const LaneStart& start, double distance);

}  // namespace lancer::wide
