// The scenes of tests/pairs as the evaluator would give them.
#pragma once

#include <string>

#include "model/scene.h"

namespace lancer::reference {

Scene solids_scene();
Scene glass_nested_scene();
/// `motif` is decoded twice: from sRGB, and as linear.
Scene tex_planar_scene();

}  // namespace lancer::reference
