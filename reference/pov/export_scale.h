// The sizes at which POV-Ray is right, and how a scene is scaled to them.
#pragma once

#include <cstdint>
#include <optional>

#include "model/scene.h"
#include "reference/pov/export.h"
#include "reference/pov/text.h"

namespace lancer::reference::pov {

/// An axis-aligned box; empty until the first point is added.
struct Bounds {
    Vec3d low{0, 0, 0};
    Vec3d high{0, 0, 0};
    bool empty = true;

    void add(const Vec3d& p);
    void add(const Bounds& other);
    double diagonal() const { return empty ? 0 : length(high - low); }
    Vec3d center() const { return (low + high) / 2.0; }
    bool overlaps(const Bounds& other) const;
};

/// The box of a shape in its own space; nothing for a plane, which has no box.
std::optional<Bounds> shape_bounds(const Scene& scene, const Shape& shape);

/// The box that holds `bounds` after `map`.
Bounds moved(const Affine<double>& map, const Bounds& bounds);

/// The power of ten by which lengths are multiplied, so that POV-Ray is right. Its constants 1e-4
/// and 1e-3 are absolute, so larger scenes are better up to about 10,000; beyond that, hits are
/// lost. The median size of the bounded objects becomes 100 to 1,000, or at least 1 when the whole
/// scene would exceed 100,000. Without bounded objects, the distance of the camera from its look_at
/// point is used. `keep`: returns 1 for a scene whose objects have sizes from 0.05 to 500.
PowerOfTen export_scale(const Scene& scene, const ExportView& view, bool keep);

/// The largest scale at which POV-Ray can see the scene: its size becomes 100,000 to 1,000,000.
PowerOfTen largest_scale(const Scene& scene, const ExportView& view);

/// Brings an object's own space near the size that it has in the picture: lengths in its own space
/// are multiplied by `own`, then the matrix `to_picture` is applied.
struct ObjectSpace {
    PowerOfTen own;
    Affine<double> to_picture;
};
ObjectSpace object_space(const Affine<double>& to_world, PowerOfTen scale);

}  // namespace lancer::reference::pov
