#include "tracer/compile/scale.h"

#include <algorithm>
#include <vector>

#include "model/light_facts.h"
#include "model/parts.h"

namespace lancer {
namespace {

double largest(const Vec3d& p) {
    return max_component(absolute(p));
}

struct Extent {
    const Scene& scene;

    double operator()(const Sphere& s) const { return std::max(largest(s.center), s.radius); }
    double operator()(const Box& b) const { return std::max(largest(b.min), largest(b.max)); }
    double operator()(const Cylinder& c) const {
        return std::max({largest(c.base), largest(c.top), c.radius});
    }
    double operator()(const Cone& c) const {
        return std::max({largest(c.base), largest(c.top), c.base_radius, c.top_radius});
    }
    double operator()(const Torus& t) const { return t.radius; }  // true extent: at most twice this
    double operator()(const Plane& p) const { return std::abs(p.offset); }
    double operator()(const Triangle& t) const {
        return std::max({largest(t.points[0]), largest(t.points[1]), largest(t.points[2])});
    }
    double operator()(const MeshRef& m) const { return largest_of(scene.meshes[m.mesh]->vertices); }
    double operator()(const PatchRef& p) const {
        return largest_of(scene.patches[p.patch].control);
    }
    double operator()(const LatheRef& l) const { return largest_of(scene.lathes[l.lathe].profile); }
    double operator()(const PrismRef& r) const {
        const Prism& prism = scene.prisms[r.prism];
        return std::max({largest_of(prism.outline), std::abs(prism.bottom), std::abs(prism.top)});
    }
    /// Only the leaves of a composite have an extent.
    double operator()(const CompositeRef&) const { return 0; }

    static double largest_of(const std::vector<Vec3d>& points) {
        double most = 0;
        for (const Vec3d& p : points) most = std::max(most, largest(p));
        return most;
    }
    static double largest_of(const std::vector<Vec2d>& points) {
        double most = 0;
        for (const Vec2d& p : points) most = std::max({most, std::abs(p.x), std::abs(p.y)});
        return most;
    }
};

/// extent_of() for all shapes of a scene. It computes the extent of each mesh once.
class ShapeExtents {
  public:
    explicit ShapeExtents(const Scene& scene) : scene_(scene), meshes_(scene.meshes.size(), -1) {}

    double of(const Shape& shape) {
        const auto* ref = std::get_if<MeshRef>(&shape);
        if (ref == nullptr) return extent_of(shape, scene_);
        double& extent = meshes_[ref->mesh];
        if (extent < 0) extent = extent_of(shape, scene_);
        return extent;
    }

  private:
    const Scene& scene_;
    std::vector<double> meshes_;  ///< -1: not known yet
};

}  // namespace

double extent_of(const Shape& shape, const Scene& scene) {
    return std::visit(Extent{scene}, shape);
}

int scale_exponent(const Scene& scene) {
    ShapeExtents extents(scene);
    // The maximum of exponents, not of values: a transform of 1e300 may not be finite.
    int most = -100000;
    const auto take = [&](double value) {
        if (value > 0) most = std::max(most, -exponent_for(value));
    };
    for_each_part(scene, [&](const Object& object) {
        const double extent = extents.of(object.shape);
        const Affine<double>& m = scene.transforms[object.transform];
        double growth = 0;
        for (const Vec3d& row : m.rows) growth = std::max(growth, largest(row));
        if (extent > 0 && growth > 0)
            most = std::max(most, -exponent_for(extent) - exponent_for(growth));
        take(largest(m.shift));
    });
    for (const Camera& camera : scene.cameras) {
        take(largest(camera.position));
        take(largest(camera.look_at));
    }
    for (const Light& light : scene.lights) {
        if (const Vec3d* position = facts_of(light.kind).position) take(largest(*position));
    }
    return most == -100000 ? 0 : -most;
}

}  // namespace lancer
