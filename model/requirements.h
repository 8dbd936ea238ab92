// What a scene requires of the renderer, and which object requires it first. Features that nothing
// requires cost nothing. The tracer's World and `lancer info` use this.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "model/scene.h"
#include "model/settings.h"

namespace lancer {

/// A feature of the renderer that scenes may not need.
enum class Feature : std::uint8_t {
    meshes,             ///< an acceleration structure of triangles
    splines,            ///< patch, lathe or prism
    smooth_normals,     ///< interpolated
    textures,           ///< coordinates at each hit
    image_textures,     ///< images decoded and looked up
    shadows,            ///< a ray to each light
    filtered_shadows,   ///< some caster lets light through, so shadows are more than yes or no
    reflection,         ///< mirror rays
    fresnel,            ///< reflection weighted by Fresnel's equations
    transmission,       ///< rays that go on behind a surface
    media,              ///< a list of the bodies that a ray is in
    smooth_media,       ///< a second list: the bodies whose index applies
    refraction,         ///< rays that bend
    absorption,         ///< light that fades inside a body
    light_from_behind,  ///< diffuse_transmission or phong_transmission
};
inline constexpr std::size_t feature_count = 15;

/// The name of the feature in `info`, and one sentence about its meaning.
std::string_view name_of(Feature feature);
std::string_view meaning_of(Feature feature);

/// The first object that requires a feature.
struct Demand {
    std::uint32_t object = none;  ///< index into Scene::objects; none: the lights require it
    SourceSpan place;             ///< of that object or light
};

class Requirements {
  public:
    bool needs(Feature feature) const { return demand(feature).has_value(); }
    const std::optional<Demand>& demand(Feature feature) const {
        return demands_[static_cast<std::size_t>(feature)];
    }
    /// Records a demand, unless there is an earlier one.
    void add(Feature feature, const Demand& by);

    /// Whether the object is a medium: a body whose inside matters to rays, because it is
    /// transparent or has an index or an absorption of its own.
    bool is_medium(std::uint32_t object) const { return mediums_[object]; }
    /// Sets this for the next object.
    void add_medium(bool is_one) { mediums_.push_back(is_one); }

  private:
    std::vector<bool> mediums_;  ///< in the order of Scene::objects
    std::array<std::optional<Demand>, feature_count> demands_;
};

/// Whether light may pass through a surface of this material. `textures` false: the alpha of
/// textures is ignored.
bool lets_light_through(const Scene& scene, const Material& material, bool textures);

/// What the objects of `scene` require when rendered with `settings`. Features that the settings
/// switch off (shadows, smooth, textures, all recursion at depth 1) are not required.
Requirements requirements_of(const Scene& scene, const Settings& settings);

}  // namespace lancer
