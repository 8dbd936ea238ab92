// Faces of objects that may coincide with those of other objects: flat ones, and those around an
// axis or a centre.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "model/scene.h"

namespace lancer::reference::pov {

/// Points p with normal·p = offset within the triangle or parallelogram of `corners`, which
/// encloses the face. Without corners, a whole plane.
struct FlatFace {
    Vec3d normal{0, 0, 0};  ///< unit; out of a body
    double offset = 0;
    /// a corner, its two neighbours, and for a parallelogram the fourth
    std::vector<Vec3d> corners;
};

/// A piece of the side of a cylinder or cone. At height h along the axis, measured from the axis'
/// point nearest the origin, the radius is radius + slope·h.
struct RoundFace {
    Vec3d axis{0, 0, 0};  ///< unit; its first component that is not 0 is positive
    Vec3d point{0, 0, 0};
    double radius = 0;
    double slope = 0;
    double low = 0;  ///< heights
    double high = 0;
};

struct BallFace {
    Vec3d center{0, 0, 0};
    double radius = 0;
};

struct Face {
    std::uint32_t object = 0;
    std::variant<FlatFace, RoundFace, BallFace> form;
    /// For a round face: 1 when the body is inside, -1 when it is around. 1 for a flat face and a
    /// sphere.
    int outward = 1;
    std::uint32_t part = none;  ///< of a composite: the leaf
    /// For a box: twice the axis, plus one for the upper face. For a capped cylinder or cone: side,
    /// base, top. Such faces move one by one; other bodies grow as a whole.
    std::uint32_t index = none;
    bool shows = true;    ///< false: a cutter's face that lies in a face of its own body
    bool turned = false;  ///< a cutter's face as the body shows it: inside and outside exchanged
};

/// The faces of all objects, at most `most`, meshes last. For a curved lathe or prism, only the
/// flat and straight parts; none for a patch.
std::vector<Face> faces_of(const Scene& scene, std::size_t most);

/// Whether two faces coincide, at least in part.
bool coincide(const Face& a, const Face& b);

/// Whether two coincident faces point the same way: the two bodies lie on the same side.
bool look_alike(const Face& a, const Face& b);

/// How far the face moves outwards when the object grows about `center` by its own size: the
/// distance of the face, or of its tangent plane. Negative when growing moves it inwards.
double reach(const Face& face, const Vec3d& center);

}  // namespace lancer::reference::pov
