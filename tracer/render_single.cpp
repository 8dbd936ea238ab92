#include "tracer/render_types.h"
#include "tracer/renderer_of.h"

namespace lancer {

std::unique_ptr<RayTreeRenderer> compile_single(const Scene& scene, const Settings& settings) {
    return std::make_unique<RendererOf<float>>(scene, settings);
}

}  // namespace lancer
