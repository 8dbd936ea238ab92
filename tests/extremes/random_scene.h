// Random scenes.
#pragma once

#include "model/scene.h"

namespace lancer::extremes {

/// A dozen objects of random shape, material and transform on a plane, 96 x 72 pixels; the same for
/// the same seed on every machine.
Scene random_scene(unsigned seed);

/// The same with every shape, material, texture, light and camera of the language.
Scene random_anything(unsigned seed);

}  // namespace lancer::extremes
