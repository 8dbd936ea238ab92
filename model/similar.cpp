#include "model/similar.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lancer {
namespace {

/// p -> factor * renamed(p) + shift
struct Similarity {
    double factor = 1;
    int renamings = 0;  ///< 0, 1 or 2
    Vec3d shift{0, 0, 0};

    Vec3d direction(const Vec3d& d) const {
        if (renamings == 0) return d;
        return renamings == 1 ? Vec3d(d.z, d.x, d.y) : Vec3d(d.y, d.z, d.x);
    }
    Vec3d place(const Vec3d& p) const { return direction(p) * factor + shift; }
    Affine<double> map() const {
        Affine<double> m;
        for (int row = 0; row < 3; ++row) {
            m.rows[static_cast<std::size_t>(row)] = Vec3d(0);
            m.rows[static_cast<std::size_t>(row)][(row + 3 - renamings) % 3] = factor;
        }
        m.shift = shift;
        return m;
    }
};

bool is_along_an_axis(const Vec3d& v) {
    return (v.x != 0) + (v.y != 0) + (v.z != 0) == 1;
}

/// Changes the numbers of a shape; false for one that needs a transform instead.
struct Rewriter {
    Scene& scene;
    const Similarity& to;
    std::map<std::uint32_t, std::uint32_t>& meshes;  ///< from an index to that of the changed copy

    bool operator()(Sphere& s) const {
        s.center = to.place(s.center);
        s.radius *= to.factor;
        return true;
    }
    bool operator()(Box& b) const {
        b.min = to.place(b.min);
        b.max = to.place(b.max);
        return true;
    }
    bool operator()(Cylinder& c) const {
        c.base = to.place(c.base);
        c.top = to.place(c.top);
        c.radius *= to.factor;
        return true;
    }
    bool operator()(Cone& c) const {
        c.base = to.place(c.base);
        c.top = to.place(c.top);
        c.base_radius *= to.factor;
        c.top_radius *= to.factor;
        return true;
    }
    /// A torus is centred on the origin of its own space.
    bool operator()(Torus&) const { return false; }
    bool operator()(Plane& p) const {
        const bool stays = to.shift == Vec3d(0);
        // For any other normal, adding n·shift would round the offset.
        if (!stays && !is_along_an_axis(p.normal)) return false;
        p.normal = to.direction(p.normal);
        p.offset *= to.factor;
        if (!stays) {
            for (int i = 0; i < 3; ++i) {
                if (p.normal[i] != 0) p.offset += p.normal[i] > 0 ? to.shift[i] : -to.shift[i];
            }
        }
        return true;
    }
    bool operator()(Triangle& t) const {
        if (t.attributes != none) return false;
        for (Vec3d& p : t.points) p = to.place(p);
        return true;
    }
    bool operator()(MeshRef& ref) const {
        const auto [entry, fresh] =
            meshes.try_emplace(ref.mesh, static_cast<std::uint32_t>(scene.meshes.size()));
        if (fresh) {
            auto copy = std::make_shared<Mesh>(*scene.meshes[ref.mesh]);
            for (Vec3d& v : copy->vertices) v = to.place(v);
            for (Vec3d& n : copy->normals) n = to.direction(n);
            scene.meshes.push_back(std::move(copy));
        }
        ref.mesh = entry->second;
        return true;
    }
    bool operator()(PatchRef&) const { return false; }
    bool operator()(LatheRef&) const { return false; }
    bool operator()(PrismRef&) const { return false; }
    bool operator()(CompositeRef&) const { return true; }  // its leaves are changed
};

struct LightRewriter {
    const Similarity& to;

    void operator()(PointLight& light) const {
        light.position = to.place(light.position);
        change(light.fade);
    }
    void operator()(DirectionalLight& light) const {
        light.direction = to.direction(light.direction);
    }
    void operator()(SpotLight& light) const {
        light.position = to.place(light.position);
        light.look_at = to.place(light.look_at);
        change(light.fade);
    }

  private:
    void change(std::optional<Fade>& fade) const {
        if (fade) fade->distance *= to.factor;
    }
};

class Changer {
  public:
    Changer(const Scene& scene, const Similarity& to) : scene_(scene), to_(to) {}

    Scene run() {
        for (Object& object : scene_.objects) change(object);
        for (Material& material : scene_.materials) material.absorption /= to_.factor;
        for (Camera& camera : scene_.cameras) change(camera);
        for (Light& light : scene_.lights) change(light);
        if (scene_.sky) scene_.sky->axis = to_.direction(scene_.sky->axis);
        if (scene_.settings.tolerance) *scene_.settings.tolerance *= to_.factor;
        return std::move(scene_);
    }

  private:
    std::uint32_t changed_transform(std::uint32_t transform) {
        const auto [entry, fresh] = transforms_.try_emplace(
            transform, static_cast<std::uint32_t>(scene_.transforms.size()));
        if (fresh) scene_.transforms.push_back(compose(to_.map(), scene_.transforms[transform]));
        return entry->second;
    }

    void change(Composite& composite) {
        for (Composite::Leaf& leaf : composite.leaves) {
            const bool textured = scene_.materials[leaf.object.material].texture != none;
            if (textured) leaf.texture_space = changed_transform(leaf.texture_space);
            change(leaf.object);
        }
    }

    void change(Object& object) {
        if (const auto* ref = std::get_if<CompositeRef>(&object.shape)) {
            change(scene_.composites[ref->composite]);
            return;
        }
        const bool plain =
            object.transform == 0 && scene_.materials[object.material].texture == none;
        if (plain && std::visit(Rewriter{scene_, to_, meshes_}, object.shape)) return;
        keep_tolerance(object);
        object.transform = changed_transform(object.transform);
    }

    /// A patch's own tolerance bounds the distance in its own space and in the world, so it is
    /// scaled by the larger of the two factors: see Solids::own_tolerance in the tracer.
    void keep_tolerance(Object& object) {
        auto* ref = std::get_if<PatchRef>(&object.shape);
        if (ref == nullptr || !scene_.patches[ref->patch].tolerance || to_.factor == 1) return;
        const double stretch = largest_stretch(scene_.transforms[object.transform]);
        Patch patch = scene_.patches[ref->patch];
        *patch.tolerance *= std::max(to_.factor * stretch, 1.0) / std::max(stretch, 1.0);
        ref->patch = static_cast<std::uint32_t>(scene_.patches.size());
        scene_.patches.push_back(std::move(patch));
    }

    void change(Camera& camera) {
        camera.position = to_.place(camera.position);
        camera.look_at = to_.place(camera.look_at);
        camera.up = to_.direction(camera.up);
        if (auto* parallel = std::get_if<OrthographicProjection>(&camera.projection))
            parallel->height *= to_.factor;
    }

    void change(Light& light) { std::visit(LightRewriter{to_}, light.kind); }

    Scene scene_;
    Similarity to_;
    std::map<std::uint32_t, std::uint32_t> meshes_;
    std::map<std::uint32_t, std::uint32_t> transforms_;
};

}  // namespace

Scene scaled(const Scene& scene, double factor) {
    return Changer(scene, {factor, 0, Vec3d(0)}).run();
}

Scene moved(const Scene& scene, const Vec3d& by) {
    return Changer(scene, {1, 0, by}).run();
}

Scene axes_renamed(const Scene& scene, int times) {
    return Changer(scene, {1, (times % 3 + 3) % 3, Vec3d(0)}).run();
}

Scene seen_from_afar(const Scene& scene, double times) {
    Scene far = scene;
    for (Camera& camera : far.cameras) {
        camera.position = camera.look_at + (camera.position - camera.look_at) * times;
        if (auto* lens = std::get_if<PerspectiveProjection>(&camera.projection)) {
            const double half = elementary::tan(radians(lens->fov / 2));
            lens->fov = 2 * degrees(elementary::atan2(half / times, 1.0));
        }
    }
    return far;
}

}  // namespace lancer
