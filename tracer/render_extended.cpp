#include "tracer/render_types.h"
#include "tracer/renderer_of.h"

namespace lancer {

std::unique_ptr<RayTreeRenderer> compile_extended(const Scene& scene, const Settings& settings) {
    return std::make_unique<RendererOf<long double>>(scene, settings);
}

}  // namespace lancer
