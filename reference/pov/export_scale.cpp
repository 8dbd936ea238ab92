#include "reference/pov/export_scale.h"

#include <algorithm>
#include <cmath>

namespace lancer::reference::pov {

void Bounds::add(const Vec3d& p) {
    if (empty) {
        low = high = p;
        empty = false;
        return;
    }
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

void Bounds::add(const Bounds& other) {
    if (other.empty) return;
    add(other.low);
    add(other.high);
}

bool Bounds::overlaps(const Bounds& other) const {
    return !empty && !other.empty && low.x <= other.high.x && other.low.x <= high.x &&
           low.y <= other.high.y && other.low.y <= high.y && low.z <= other.high.z &&
           other.low.z <= high.z;
}

Bounds moved(const Affine<double>& map, const Bounds& bounds) {
    Bounds out;
    for (int corner = 0; corner < 8 && !bounds.empty; ++corner)
        out.add(map_point(map, Vec3d(corner & 1 ? bounds.high.x : bounds.low.x,
                                     corner & 2 ? bounds.high.y : bounds.low.y,
                                     corner & 4 ? bounds.high.z : bounds.low.z)));
    return out;
}

namespace {

/// floor(log10(x)), for finite x > 0.
int decade(double x) {
    int n = 0;
    for (; x >= 10; x /= 10) ++n;
    for (; x < 1; x *= 10) --n;
    return n;
}

/// The sizes that determine the export scale.
struct SceneSize {
    double whole = 0;    ///< diagonal of all bounded objects and the camera
    double typical = 0;  ///< of an object: the median
};

SceneSize size_of(const Scene& scene, const ExportView& view) {
    const Camera& camera = scene.cameras[view.camera];
    Bounds all;
    all.add(camera.position);
    std::vector<double> sizes;
    for (const Object& object : scene.objects) {
        const std::optional<Bounds> own = shape_bounds(scene, object.shape);
        if (!own) continue;
        const Bounds world = moved(scene.transforms[object.transform], *own);
        all.add(world);
        sizes.push_back(world.diagonal());
    }
    double typical = length(camera.look_at - camera.position);
    if (sizes.empty()) all.add(camera.look_at);
    if (!sizes.empty()) {
        const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
        std::nth_element(sizes.begin(), middle, sizes.end());
        typical = *middle;
    }
    return {all.diagonal(), typical};
}

bool is_size(double value) {
    return value > 0 && std::isfinite(value);
}

}  // namespace

PowerOfTen export_scale(const Scene& scene, const ExportView& view, bool keep) {
    const SceneSize size = size_of(scene, view);
    if (!is_size(size.typical)) return {};
    if (keep && size.typical >= 0.05 && size.typical <= 500 && size.whole <= 1e6) return {};
    const int least = -decade(size.typical);
    if (!is_size(size.whole)) return {least};
    return {std::max(least, std::min(2 + least, 4 - decade(size.whole)))};
}

PowerOfTen largest_scale(const Scene& scene, const ExportView& view) {
    const SceneSize size = size_of(scene, view);
    if (!is_size(size.whole)) return export_scale(scene, view, false);
    return {5 - decade(size.whole)};
}

ObjectSpace object_space(const Affine<double>& to_world, PowerOfTen scale) {
    if (to_world == Affine<double>{}) return {scale, {}};
    ObjectSpace space{scale, to_world};
    // The volume tells how much larger the object is in the world than in its own space.
    const double volume = std::abs(determinant(to_world));
    if (volume > 0 && std::isfinite(volume)) {
        const int decades = decade(elementary::cbrt(volume) * 2);
        if (decades < -1 || decades > 1) space.own.exponent += decades;
    }
    const PowerOfTen rest{scale.exponent - space.own.exponent};
    for (Vec3d& row : space.to_picture.rows) row = rest(row);
    space.to_picture.shift = scale(to_world.shift);
    return space;
}

}  // namespace lancer::reference::pov
