#include "tests/quad/renderer.h"

#include "tests/quad/quad.h"
#include "tracer/compile/geometry_build.h"
#include "tracer/intersect/searches_build.h"
#include "tracer/recursion/cut_tracer_build.h"
#include "tracer/recursion/recorded_tracer_build.h"
#include "tracer/renderer_of.h"
#include "tracer/shapes/bicubic_build.h"

namespace lancer {

template class CutTracer<Quad>;
template class RecordedTracer<Quad>;

template class BicubicSurface<Quad>;

std::unique_ptr<Renderer> compile_quad(const Scene& scene, const Settings& settings) {
    return std::make_unique<RendererOf<Quad>>(scene, settings);
}

}  // namespace lancer
