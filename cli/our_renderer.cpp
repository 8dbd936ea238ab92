#include "cli/our_renderer.h"

#include <memory>

#include "cli/stopwatch.h"
#include "tracer/render.h"

namespace lancer::cli {
namespace {

reference::Probe probe_of(const std::shared_ptr<const Renderer>& renderer, const View& view) {
    return [renderer, view](double x, double y) {
        const Probe probe = renderer->probe(view, x, y);
        return reference::ProbeSample{probe.color, probe.object, probe.depth, probe.normal,
                                      probe.lit,   probe.path,   probe.rays};
    };
}

/// Compiles when it is first asked: most pictures have no pixel to ask about.
reference::Probe probe_by_rules(const std::shared_ptr<const Scene>& scene, const View& view,
                                const PovRayRules& rules) {
    return [scene, view, rules, probe = reference::Probe()](double x, double y) mutable {
        if (!probe) probe = probe_of(compile_by_povray(*scene, scene->settings, rules), view);
        return probe(x, y);
    };
}

}  // namespace

reference::OurPicture render_ours(const Scene& scene, const reference::ExportView& exported) {
    View view;
    view.camera = exported.camera;
    view.width = exported.width;
    view.height = exported.height;
    Settings settings = scene.settings;
    settings.threads = 1;  // whole scenes run side by side

    const Stopwatch watch;
    const std::shared_ptr<const Renderer> renderer = compile(scene, settings);
    RayCounts rays;
    reference::OurPicture picture;
    picture.image = renderer->render(view, {}, rays);
    picture.seconds = watch.seconds();
    picture.rays = rays.rays();
    picture.probe = probe_of(renderer, view);
    picture.by_rules = [view, scene = std::make_shared<const Scene>(scene)](
                           const PovRayRules& rules) { return probe_by_rules(scene, view, rules); };
    return picture;
}

}  // namespace lancer::cli
