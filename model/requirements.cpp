#include "model/requirements.h"

#include <algorithm>

#include "model/bodies.h"
#include "model/parts.h"
#include "model/shape_facts.h"

namespace lancer {
namespace {

struct Words {
    std::string_view name;
    std::string_view meaning;
};

constexpr std::array<Words, feature_count> words{{
    {"meshes", "triangles with an acceleration structure of their own"},
    {"splines", "curved surfaces from control points"},
    {"smooth normals", "normals interpolated over triangles"},
    {"textures", "texture coordinates at each hit"},
    {"image textures", "images decoded and looked up"},
    {"shadows", "a ray to each light from each hit"},
    {"filtered shadows", "shadows of objects that let light through"},
    {"reflection", "mirror rays"},
    {"fresnel", "reflection weighted by Fresnel's equations"},
    {"transmission", "rays that continue behind a surface"},
    {"media", "a list of the bodies that each ray is inside of"},
    {"smooth media", "a second list, for meshes whose normals are interpolated"},
    {"refraction", "rays that bend"},
    {"absorption", "light that fades inside a body"},
    {"light from behind", "lights that shine through a surface from behind"},
}};

class Collector {
  public:
    Collector(const Scene& scene, const Settings& settings) : scene_(scene), settings_(settings) {}

    Requirements collect() {
        for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
            const Object& object = scene_.objects[i];
            const Demand demand{i, object.place};
            add_shape(object, demand);
            add_surface(object, demand);
        }
        add_lights();
        return found_;
    }

  private:
    void add_shape(const Object& object, const Demand& demand) {
        const ShapeFacts facts = facts_of(scene_, object.shape);
        if (facts.mesh) found_.add(Feature::meshes, demand);
        if (facts.spline) found_.add(Feature::splines, demand);
        if (settings_.smooth && facts.interpolates) found_.add(Feature::smooth_normals, demand);
    }

    void add_surface(const Object& object, const Demand& demand) {
        bool transparent = false;
        for_each_part(scene_, object, [&](const Object& part) {
            const Material& m = scene_.materials[part.material];
            add_face(m, demand);
            if (!lets_light_through(scene_, m, settings_.textures)) return;
            transparent = true;
            add_transparent(object, m, demand);
        });
        add_inside(object, scene_.materials[object.material], transparent, demand);
    }

    void add_face(const Material& m, const Demand& demand) {
        if (settings_.textures && m.texture != none) {
            found_.add(Feature::textures, demand);
            if (std::holds_alternative<ImageTexture>(scene_.textures[m.texture].pattern))
                found_.add(Feature::image_textures, demand);
        }
        if (m.diffuse_transmission > 0 || m.phong_transmission > 0)
            found_.add(Feature::light_from_behind, demand);
        if (settings_.max_depth > 1 && max_component(m.reflection) > 0) {
            found_.add(Feature::reflection, demand);
            if (m.fresnel) found_.add(Feature::fresnel, demand);
        }
    }

    void add_transparent(const Object& object, const Material& m, const Demand& demand) {
        found_.add(Feature::transmission, demand);
        if (m.fresnel) found_.add(Feature::fresnel, demand);
        if (object.casts_shadow && settings_.shadows) {
            if (!first_filter_) first_filter_ = demand;
        }
    }

    /// Adds what the inside of a body requires. An opaque body can also have rays inside of it.
    void add_inside(const Object& object, const Material& m, bool transparent,
                    const Demand& demand) {
        const bool absorbs = max_component(m.absorption) > 0;
        const bool matters = transparent || m.ior != 1 || absorbs;
        const bool medium = matters && bodies_.holds(object.shape);
        found_.add_medium(medium);
        if (!medium) return;
        if (transparent || absorbs) found_.add(Feature::media, demand);
        if (transparent && m.ior != 1) found_.add(Feature::refraction, demand);
        if (absorbs) found_.add(Feature::absorption, demand);
        for_each_part(scene_, object, [&](const Object& part) {
            const auto* mesh = std::get_if<MeshRef>(&part.shape);
            if (mesh != nullptr && mesh->smooth && settings_.smooth)
                found_.add(Feature::smooth_media, demand);
        });
    }

    void add_lights() {
        if (!settings_.shadows || scene_.objects.empty()) return;
        const auto light = std::find_if(scene_.lights.begin(), scene_.lights.end(),
                                        [](const Light& l) { return l.shadows; });
        if (light == scene_.lights.end()) return;
        found_.add(Feature::shadows, {none, light->place});
        if (first_filter_) found_.add(Feature::filtered_shadows, *first_filter_);
    }

    const Scene& scene_;
    const Settings& settings_;
    Requirements found_;
    std::optional<Demand> first_filter_;
    Bodies bodies_{scene_};  ///< called only when needed: a mesh takes a while
};

}  // namespace

std::string_view name_of(Feature feature) {
    return words[static_cast<std::size_t>(feature)].name;
}
std::string_view meaning_of(Feature feature) {
    return words[static_cast<std::size_t>(feature)].meaning;
}

void Requirements::add(Feature feature, const Demand& by) {
    std::optional<Demand>& slot = demands_[static_cast<std::size_t>(feature)];
    if (!slot) slot = by;
}

bool lets_light_through(const Scene& scene, const Material& material, bool textures) {
    if (material.filter > 0 || material.transmission > 0) return true;
    if (!textures || material.texture == none) return false;
    const auto* image = std::get_if<ImageTexture>(&scene.textures[material.texture].pattern);
    if (image == nullptr) return false;
    // Light passes outside of an image that is shown once, and where its alpha allows it.
    return image->wrap == ImageTexture::Wrap::once ||
           scene.images[image->image].pixels->channels == 4;
}

Requirements requirements_of(const Scene& scene, const Settings& settings) {
    return Collector(scene, settings).collect();
}

}  // namespace lancer
