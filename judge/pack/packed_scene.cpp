#include "judge/pack/packed_scene.h"

#include <memory>
#include <variant>

#include "model/plain_color.h"

namespace lancer::judge {

namespace {

/// Calls visit(object) for the scene's objects and for the parts of its composites.
template <class Visit>
void for_each_object(Scene& scene, const Visit& visit) {
    for (Object& object : scene.objects) visit(object);
    for (Composite& composite : scene.composites)
        for (Composite::Leaf& leaf : composite.leaves) visit(leaf.object);
}

void leave_out_textures(Scene& scene) {
    const Scene before = scene;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        scene.materials[i].color = plain_color(before, before.materials[i]);
        scene.materials[i].texture = none;
    }
    scene.settings.textures = true;
}

void leave_out_normals(Scene& scene) {
    for_each_object(scene, [](Object& object) {
        if (auto* mesh = std::get_if<MeshRef>(&object.shape)) mesh->smooth = false;
    });
    for (TriangleAttributes& attributes : scene.triangle_attributes) attributes.normals.reset();
    scene.settings.smooth = true;
}

/// The tolerance of an object's own surface, or the one that the scene sets for such surfaces.
struct ToleranceOf {
    const Scene& scene;

    bool operator()(const PatchRef& p) const { return asks(scene.patches[p.patch].tolerance); }
    bool operator()(const LatheRef& l) const { return asks(scene.lathes[l.lathe].tolerance); }
    bool operator()(const PrismRef& p) const { return asks(scene.prisms[p.prism].tolerance); }
    template <class Other>
    bool operator()(const Other&) const {
        return false;
    }
    bool asks(const std::optional<double>& own) const {
        return own.has_value() || scene.settings.tolerance.has_value();
    }
};

void leave_out_tolerances(Scene& scene, std::vector<Diagnostic>& warnings) {
    for_each_object(scene, [&](Object& object) {
        if (!std::visit(ToleranceOf{scene}, object.shape)) return;
        warnings.push_back({Severity::warning,
                            object.place,
                            "this surface has a tolerance; the pack holds the true surface and its "
                            "picture",
                            "",
                            {}});
    });
    for (Patch& patch : scene.patches) patch.tolerance.reset();
    for (Lathe& lathe : scene.lathes) lathe.tolerance.reset();
    for (Prism& prism : scene.prisms) prism.tolerance.reset();
    scene.settings.tolerance.reset();
}

}  // namespace

Scene as_packed(const Scene& scene, std::vector<Diagnostic>& warnings) {
    Scene packed = scene;
    if (!packed.settings.textures) leave_out_textures(packed);
    if (!packed.settings.smooth) leave_out_normals(packed);
    leave_out_tolerances(packed, warnings);
    return packed;
}

void round_images(Scene& scene) {
    for (SceneImage& image : scene.images) {
        auto rounded = std::make_shared<Image>(*image.pixels);
        for (double& value : rounded->data) value = static_cast<float>(value);
        image.pixels = std::move(rounded);
    }
}

}  // namespace lancer::judge
