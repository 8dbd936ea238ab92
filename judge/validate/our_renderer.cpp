#include "judge/validate/our_renderer.h"

#include <chrono>

namespace lancer::judge {

namespace {

ProbeFunction probe_of(std::shared_ptr<const Renderer> renderer, const View& view) {
    return [renderer = std::move(renderer), view](double x, double y) {
        return renderer->probe(view, x, y);
    };
}

}  // namespace

ProbeFunction probe_by_rules(const std::shared_ptr<const Scene>& scene, const View& view,
                             const PovRayRules& rules) {
    return [scene, view, rules, probe = ProbeFunction()](double x, double y) mutable {
        if (!probe) probe = probe_of(compile_by_povray(*scene, scene->settings, rules), view);
        return probe(x, y);
    };
}

View tracer_view(const reference::ExportView& exported) {
    View view;
    view.camera = exported.camera;
    view.width = exported.width;
    view.height = exported.height;
    return view;
}

PovRayRules rules_of(const reference::ExportResult& exported) {
    PovRayRules rules;
    rules.unit = exported.unit;
    rules.patch_halvings = exported.patch_halvings;
    return rules;
}

OurPicture render_ours(const std::shared_ptr<const Scene>& scene,
                       const reference::ExportView& exported) {
    const View view = tracer_view(exported);
    Settings settings = scene->settings;
    settings.threads = 1;  // whole scenes run side by side

    const auto start = std::chrono::steady_clock::now();
    const std::shared_ptr<const Renderer> renderer = compile(*scene, settings);
    RayCounts rays;
    OurPicture picture;
    picture.image = renderer->render(view, {}, rays);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    picture.seconds = taken.count();
    picture.rays = rays.rays();
    picture.probe = probe_of(renderer, view);
    picture.by_rules = [view, scene](const PovRayRules& rules) {
        return probe_by_rules(scene, view, rules);
    };
    return picture;
}

}  // namespace lancer::judge
