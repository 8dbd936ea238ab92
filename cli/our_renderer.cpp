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
    view.absorption_by_povray = true;
    picture.probe_by_rules = probe_of(renderer, view);
    return picture;
}

}  // namespace lancer::cli
