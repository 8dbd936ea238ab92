// Faces of different objects in one place: glued blocks, a glass standing on a table.
#pragma once

#include <vector>

#include "model/scene.h"
#include "reference/pov/export.h"
#include "reference/pov/faces.h"

namespace lancer::reference::pov {

/// Two faces in one place. `front` and `back` say what the resolution asks for: with `alike` that
/// `front` lies further out, else that the two bodies overlap, and `front` is the one to grow.
struct FacePair {
    Face front;
    Face back;
    bool alike = false;
    Coincidence::Resolution resolution = Coincidence::Resolution::none;
};

/// All pairs. Looks at the first 4,000 faces.
std::vector<FacePair> face_pairs(const Scene& scene);

/// One entry for two objects, at the first face that they share, by the order of declaration.
std::vector<Coincidence> coincidences(const std::vector<FacePair>& pairs);

}  // namespace lancer::reference::pov
