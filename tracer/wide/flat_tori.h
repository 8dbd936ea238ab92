// Tori as plain numbers.
#pragma once

#include "tracer/rays/frame.h"
#include "tracer/shapes/torus_line.h"
#include "tracer/wide/scene.h"

namespace lancer::wide {

/// \param frame   index of the torus' own space; `nothing`: the world
/// \param frames  the world's
Torus flat_torus(const TorusSolid<double>& torus, std::uint32_t frame,
                 const lancer::Frame<double>* frames);

}  // namespace lancer::wide
