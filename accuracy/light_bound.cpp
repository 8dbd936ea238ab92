#include "accuracy/light_bound.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "model/light_facts.h"

namespace lancer::accuracy {
namespace {

Color larger(const Color& a, const Color& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

Color largest_stop(const Gradient& gradient) {
    Color most(0);
    for (const Gradient::Stop& stop : gradient.stops) most = larger(most, stop.color);
    return most;
}

/// The largest colour of a texture, per channel.
class LargestColor {
  public:
    explicit LargestColor(const Scene& scene) : scene_(scene) {}

    Color operator()(const ImageTexture& texture) const {
        const Image& image = *scene_.images[texture.image].pixels;
        Color most(0);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const double* p = image.pixel(x, y);
                most = larger(most, {p[0], p[1], p[2]});
            }
        }
        return most;
    }
    Color operator()(const Checker& checker) const { return larger(checker.even, checker.odd); }
    Color operator()(const Gradient& gradient) const { return largest_stop(gradient); }
    Color operator()(const VertexColors&) const {
        Color most(0);
        for (const auto& mesh : scene_.meshes)
            for (const Color& color : mesh->colors) most = larger(most, color);
        return most;
    }

  private:
    const Scene& scene_;
};

bool has_alpha(const Scene& scene, const Texture& texture) {
    const auto* image = std::get_if<ImageTexture>(&texture.pattern);
    return image != nullptr && (scene.images[image->image].pixels->channels == 4 ||
                                image->wrap == ImageTexture::Wrap::once);
}

/// The largest light that a lamp sends to any point.
Color brightest(const Light& light) {
    const std::optional<Fade>* fade = facts_of(light.kind).fade;
    const bool fades = fade != nullptr && fade->has_value();
    return absolute(light.color) * (fades ? 2.0 : 1.0);  // 2 / (1 + (d / distance)^power)
}

/// Bounds for one material.
struct Bounds {
    Color sends{0};   ///< the light it sends by itself: ambient, emission, lit by lamps
    Color passes{0};  ///< the sum of the factors of mirrored and transmitted light
};

Bounds bounds_of(const Scene& scene, const Material& m) {
    Color color = m.color;
    double opacity = 1 - m.filter - m.transmission;
    Color transmittance = m.filter * color + Color(m.transmission);
    if (m.texture != none) {
        const Texture& texture = scene.textures[m.texture];
        color = std::visit(LargestColor(scene), texture.pattern);
        transmittance = m.filter * color + Color(m.transmission);
        if (has_alpha(scene, texture)) {
            opacity = 1;
            transmittance = Color(1);
        }
    }
    Bounds bounds;
    bounds.sends = opacity * color * (m.ambient * scene.ambient + m.emission);
    const Color tint = larger(Color(1), color);
    for (const Light& light : scene.lights) {
        const double matt = std::max(m.diffuse, m.diffuse_transmission);
        const double glossy = std::max(m.phong + m.blinn, m.phong_transmission);
        bounds.sends += brightest(light) * (opacity * color * matt + tint * glossy);
    }
    // With Fresnel reflectance F and reflection r, the factor r F + T (1 - r F) is linear in F, so
    // its largest value is at F = 0 or F = 1.
    bounds.passes = m.fresnel
                        ? larger(transmittance,
                                 m.reflection + transmittance * absolute(Color(1) - m.reflection))
                        : m.reflection + transmittance;
    // Total reflection is not tinted.
    if (max_component(transmittance) > 0 && m.ior != 1)
        bounds.passes = larger(bounds.passes, Color(1));
    return bounds;
}

std::vector<Material> used_materials(const Scene& scene) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const Object& object : scene.objects) used[object.material] = true;
    for (const Composite& composite : scene.composites)
        for (const Composite::Leaf& leaf : composite.leaves) used[leaf.object.material] = true;
    std::vector<Material> materials;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) materials.push_back(scene.materials[i]);
    return materials;
}

}  // namespace

bool has_branches(const Scene& scene) {
    const std::vector<Material> materials = used_materials(scene);
    return std::any_of(materials.begin(), materials.end(), [&](const Material& m) {
        return max_component(m.reflection) > 0 || m.filter > 0 || m.transmission > 0 ||
               (m.texture != none && has_alpha(scene, scene.textures[m.texture]));
    });
}

Color most_light(const Scene& scene, int surfaces) {
    const Color behind = scene.sky ? largest_stop(*scene.sky) : scene.background;
    std::vector<Bounds> materials;
    for (const Material& m : used_materials(scene)) materials.push_back(bounds_of(scene, m));
    Color most = behind;
    for (int surface = 0; surface < surfaces; ++surface) {
        Color next = behind;
        for (const Bounds& m : materials) next = larger(next, m.sends + m.passes * most);
        if (next == most) break;
        most = next;
    }
    return most;
}

}  // namespace lancer::accuracy
