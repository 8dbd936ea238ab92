#include "tracer/render_types.h"
#include "tracer/renderer_of.h"

namespace lancer {

std::unique_ptr<RayTreeRenderer> compile_double(const Scene& scene, const Settings& settings,
                                                Level level) {
    return std::make_unique<RendererOf<double>>(scene, settings, level);
}

std::unique_ptr<Renderer> compile_by_povray(const Scene& scene, const Settings& settings,
                                            const PovRayRules& rules) {
    return std::make_unique<RendererOf<double>>(scene, settings, rules);
}

}  // namespace lancer
