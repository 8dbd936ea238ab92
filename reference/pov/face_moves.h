// Moves single faces of boxes, cylinders and cones.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

#include "model/affine.h"
#include "model/shapes.h"

namespace lancer::reference::pov {

/// Moves a face of a shape outwards by the distance `by` in the world.
struct FaceMove {
    const Affine<double>& to_world;
    std::uint32_t face;
    double by;

    /// The distance along an axis of the shape's own space.
    double along(const Vec3d& axis) const {
        return by * length(map_transposed(inverse(to_world), axis));
    }

    void operator()(Box& box) const {
        const int axis = static_cast<int>(face / 2);
        Vec3d unit(0.0);
        unit[axis] = 1;
        (face % 2 == 0 ? box.min : box.max)[axis] += (face % 2 == 0 ? -1 : 1) * along(unit);
    }
    void operator()(Cylinder& s) const {
        Cone cone{s.base, s.top, s.radius, s.radius, s.capped};
        (*this)(cone);
        s = {cone.base, cone.top, cone.base_radius, s.capped};
    }
    /// The side keeps its place when an end moves. Moving the side itself requires a similarity.
    void operator()(Cone& s) const {
        const Vec3d axis = normalize(s.top - s.base);
        const double slope = (s.top_radius - s.base_radius) / length(s.top - s.base);
        if (face == 0) {
            const double wider =
                by / length(map_vector(to_world, Vec3d(1, 0, 0))) * std::sqrt(1 + slope * slope);
            s.base_radius += wider;
            s.top_radius += wider;
            return;
        }
        const double longer = along(axis);
        if (face == 1) {
            s.base = s.base - longer * axis;
            s.base_radius = std::max(0.0, s.base_radius - slope * longer);
        } else {
            s.top = s.top + longer * axis;
            s.top_radius = std::max(0.0, s.top_radius + slope * longer);
        }
    }
    void operator()(auto&) const {}
};

/// Checks the thickness: a face that moves inwards may reach the opposite one.
struct HasThickness {
    bool operator()(const Box& box) const {
        return box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z;
    }
    bool operator()(const Cylinder& moved) const {
        const Cylinder& before = std::get<Cylinder>(was);
        return moved.radius > 0 && dot(moved.top - moved.base, before.top - before.base) > 0;
    }
    bool operator()(const Cone& moved) const {
        const Cone& before = std::get<Cone>(was);
        return moved.base_radius >= 0 && moved.top_radius >= 0 &&
               moved.base_radius + moved.top_radius > 0 &&
               dot(moved.top - moved.base, before.top - before.base) > 0;
    }
    bool operator()(const auto&) const { return true; }

    const Shape& was;
};

}  // namespace lancer::reference::pov
