#include <algorithm>
#include <string>
#include <utility>

#include "judge/against/scene_variants.h"

namespace lancer::judge {

namespace {

bool is_clear(const Material& m) {
    return m.transmission > 0 || m.filter > 0;
}
bool is_glossy(const Material& m) {
    return m.phong > 0 || m.blinn > 0;
}
bool has_phong(const Material& m) {
    return m.phong > 0;
}
bool has_blinn(const Material& m) {
    return m.blinn > 0;
}
bool is_mirror(const Material& m) {
    return max_component(m.reflection) > 0;
}

/// Collects variants in which all materials of one kind are changed, if the scene has any.
class Changes {
  public:
    Changes(std::vector<SceneVariant>& variants, const Scene& scene)
        : variants_(variants), scene_(scene) {}

    template <class Which>
    bool has(const Which& which) const {
        return std::any_of(scene_.materials.begin(), scene_.materials.end(), which);
    }

    template <class Which, class Change>
    void add(std::string words, const Which& which, const Change& change) {
        if (!has(which)) return;
        variants_.push_back({std::move(words), [which, change](Scene& scene) {
                                 for (Material& material : scene.materials)
                                     if (which(material)) change(material);
                             }});
    }

  private:
    std::vector<SceneVariant>& variants_;
    const Scene& scene_;
};

void add_highlights(Changes& changes) {
    changes.add("there are no highlights", is_glossy,
                [](Material& m) { m.phong = m.blinn = m.phong_transmission = 0; });
    const auto add_exponent = [&](const std::string& words, double factor) {
        const auto change_phong = [factor](Material& m) { m.shininess *= factor; };
        const auto change_blinn = [factor](Material& m) { m.roughness /= factor; };
        changes.add("the exponents of highlights are " + words, is_glossy, [=](Material& m) {
            change_phong(m);
            change_blinn(m);
        });
        if (!changes.has(has_phong) || !changes.has(has_blinn)) return;
        changes.add("the exponents of phong highlights are " + words, has_phong, change_phong);
        changes.add("the exponents of blinn highlights are " + words, has_blinn, change_blinn);
    };
    add_exponent("twice the scene's: highlights are too small", 2);
    add_exponent("half of the scene's: highlights are too wide", 0.5);
    add_exponent("four times the scene's: highlights are too small", 4);
    add_exponent("a quarter of the scene's: highlights are too wide", 0.25);
    // The angle between H and N is roughly half of that between R and L. Some programs compensate
    // for it with a factor of 4 in the exponent.
    for (const double factor : {1.0, 4.0}) {
        const std::string with = factor == 1 ? "" : ", with 4 times the exponent";
        changes.add(
            "phong highlights use the half vector, as blinn highlights do" + with,
            [](const Material& m) { return m.phong > 0 && m.blinn == 0; },
            [factor](Material& m) {
                m.blinn = std::exchange(m.phong, 0);
                m.roughness = 1 / (factor * m.shininess);
            });
        changes.add(
            "blinn highlights use the mirrored direction, as phong highlights do" +
                (factor == 1 ? with : ", with a quarter of the exponent"),
            [](const Material& m) { return m.blinn > 0 && m.phong == 0; },
            [factor](Material& m) {
                m.phong = std::exchange(m.blinn, 0);
                m.shininess = 1 / (factor * m.roughness);
            });
    }
    const auto is_metallic = [](const Material& m) { return m.metallic > 0 && is_glossy(m); };
    changes.add("metallic is left out: all highlights have the light's colour", is_metallic,
                [](Material& m) { m.metallic = 0; });
}

void add_mirrors(Changes& changes) {
    const auto has_fresnel = [](const Material& m) { return m.fresnel && is_mirror(m); };
    changes.add("fresnel is left out: mirrors reflect as much at every angle", has_fresnel,
                [](Material& m) { m.fresnel = false; });
    changes.add("surfaces with fresnel reflect nothing", has_fresnel,
                [](Material& m) { m.reflection = Color(0); });
    changes.add(
        "fresnel is applied to every mirror",
        [](const Material& m) { return !m.fresnel && is_mirror(m); },
        [](Material& m) { m.fresnel = true; });
    changes.add("nothing is reflected", is_mirror, [](Material& m) { m.reflection = Color(0); });
}

void add_glass(Changes& changes) {
    const auto bends = [](const Material& m) { return is_clear(m) && m.ior != 1; };
    changes.add("ior is inverted: light is bent by 1/ior", bends,
                [](Material& m) { m.ior = 1 / m.ior; });
    changes.add("every ior is 1.5", bends, [](Material& m) { m.ior = 1.5; });
    changes.add("light is not bent: every ior is 1", bends, [](Material& m) { m.ior = 1; });
    changes.add(
        "absorption inside of bodies is left out",
        [](const Material& m) { return max_component(m.absorption) > 0; },
        [](Material& m) { m.absorption = Color(0); });
    changes.add("transparent surfaces are shown as opaque", is_clear,
                [](Material& m) { m.transmission = m.filter = 0; });
    changes.add(
        "filter is taken for transmission: light that passes is not tinted",
        [](const Material& m) { return m.filter > 0; },
        [](Material& m) { m.transmission += std::exchange(m.filter, 0); });
    changes.add(
        "transmission is taken for filter: light that passes is tinted",
        [](const Material& m) { return m.transmission > 0; },
        [](Material& m) { m.filter += std::exchange(m.transmission, 0); });
}

}  // namespace

void add_material_variants(std::vector<SceneVariant>& variants, const Scene& scene) {
    Changes changes(variants, scene);
    add_highlights(changes);
    add_mirrors(changes);
    add_glass(changes);
    changes.add(
        "emission is left out", [](const Material& m) { return max_component(m.emission) > 0; },
        [](Material& m) { m.emission = Color(0); });
    changes.add(
        "light from behind is left out",
        [](const Material& m) { return m.diffuse_transmission > 0 || m.phong_transmission > 0; },
        [](Material& m) { m.diffuse_transmission = m.phong_transmission = 0; });
    const auto& all = scene.materials;
    if (std::none_of(all.begin(), all.end(), is_clear)) return;
    variants.push_back({"transparent objects cast no shadow", [](Scene& s) {
                            for (Object& object : s.objects)
                                if (is_clear(s.materials[object.material]))
                                    object.casts_shadow = false;
                        }});
}

}  // namespace lancer::judge
