// Properties of each kind of solid. They have no defaults, so that a new kind must state them.
#pragma once

namespace lancer {

struct SolidTraits {
    /// A straight line meets the solid in one interval, so a line that has left it does not come
    /// back. For a cylinder without caps this is true of its inside.
    bool convex;
    /// A line meets each face at most once. So the face that a ray starts on is left out; no root
    /// needs to be divided out.
    bool face_by_face;
};

}  // namespace lancer
