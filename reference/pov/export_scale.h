// The sizes at which POV-Ray is right, and how a scene is brought there.
#pragma once

#include <cstdint>
#include <optional>

#include "model/scene.h"
#include "reference/pov/export.h"
#include "reference/pov/text.h"

namespace lancer::reference::pov {

/// A box along the axes; empty until the first point.
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

/// The box of a shape in its own space; nothing for a plane, which has none.
std::optional<Bounds> shape_bounds(const Scene& scene, const Shape& shape);

/// The box that holds `bounds` after `map`.
Bounds moved(const Affine<double>& map, const Bounds& bounds);

/// The power of ten that lengths are multiplied by, so that POV-Ray is right. Its constants are
/// absolute, 1e-4 and 1e-3, so larger is better up to about 10,000, beyond which hits are lost: the
/// median size of the bounded objects becomes 100 to 1,000, or 1 at least where the whole scene
/// would pass 100,000. Without bounded objects the camera's distance from what it looks at stands
/// for their size. `keep`: 1 for a scene whose objects are 0.05 to 500 in size.
PowerOfTen export_scale(const Scene& scene, const ExportView& view, bool keep);

/// As large as POV-Ray can see: the whole scene is 100,000 to 1,000,000 in size.
PowerOfTen largest_scale(const Scene& scene, const ExportView& view);

/// How an object's own space is brought near the size that it has in the picture: lengths in its
/// own space are multiplied by `own` before the matrix `to_picture` takes them there.
struct ObjectSpace {
    PowerOfTen own;
    Affine<double> to_picture;
};
ObjectSpace object_space(const Affine<double>& to_world, PowerOfTen scale);

}  // namespace lancer::reference::pov
