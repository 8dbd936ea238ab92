// Scenes of turned shapes that touch glass, for moves that change no digit of a coordinate.
#pragma once

#include "model/scene.h"

namespace lancer::extremes {

/// How the shapes of a scene are turned.
enum class Turns {
    quarters,  ///< about any axes, so that all their places stay multiples of 1/16
    any,       ///< by any angle, each about its own origin, which is a multiple of 1/16; by
               ///< quarters where a centre or an end of the shape is elsewhere
    any_ends   ///< all by any angle, so that centres and ends are rounded where they come to be
};

/// Cells of a grid, some of glass, each with a shape that fills it: those beside each other touch,
/// and stand on a floor. The same for the same seed on every machine.
Scene random_turned(unsigned seed, Turns turns);

}  // namespace lancer::extremes
