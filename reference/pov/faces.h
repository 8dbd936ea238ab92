// The faces of objects that another object's face can lie in: flat ones, and those round an axis or
// a centre.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "model/scene.h"

namespace lancer::reference::pov {

/// Points p with normal·p = offset within the triangle or parallelogram of `corners`, which lies
/// round the face; without corners, a whole plane.
struct FlatFace {
    Vec3d normal{0, 0, 0};  ///< unit; out of a body
    double offset = 0;
    std::vector<Vec3d> corners;  ///< one, its two neighbours, and of four the last
};

/// A piece of a cylinder's or cone's side: at height h along the axis, from the axis' point nearest
/// the origin, the radius is radius + slope·h.
struct RoundFace {
    Vec3d axis{0, 0, 0};  ///< unit; of the two the one whose first component that is not 0 is > 0
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
    /// Of a round face: 1 where the body lies within, -1 where it lies around. A flat face and a
    /// ball's have 1.
    int outward = 1;
    std::uint32_t part = none;  ///< of a composite: the leaf
    /// Of a box, twice the axis across it, and one more for the upper face; of a capped cylinder or
    /// cone the side, the base, the top. Such faces move one by one; other bodies grow as a whole.
    std::uint32_t index = none;
    bool shows = true;    ///< false: of a cutter, and in a face of its own body
    bool turned = false;  ///< of a cutter, and seen as its body's: the inside is outside
};

/// The faces of all objects, at most `most` of them, meshes last. Of a curved lathe or prism the
/// parts that are flat or straight; none of a patch.
std::vector<Face> faces_of(const Scene& scene, std::size_t most);

/// Whether two faces lie in one place, at least in part.
bool coincide(const Face& a, const Face& b);

/// Whether two faces that coincide look the same way: the two bodies lie on the same side.
bool look_alike(const Face& a, const Face& b);

/// How far the face moves outwards when the object grows about `center` by its own size: the
/// distance of the face, or of its tangent plane. Less than 0 where growing moves it inwards.
double reach(const Face& face, const Vec3d& center);

}  // namespace lancer::reference::pov
