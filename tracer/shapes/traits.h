// What every kind of solid tells of itself. Nothing has a default, so that a new one must say it.
#pragma once

namespace lancer {

struct SolidTraits {
    /// A straight line meets the solid in one piece (a cylinder without caps: its inside), so one
    /// that has left it does not come back.
    bool convex;
    /// A line meets each face once, so a start on a face is left out and not divided out.
    bool face_by_face;
};

}  // namespace lancer
