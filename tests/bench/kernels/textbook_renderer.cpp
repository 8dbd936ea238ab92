// One set of kernels: LANCER_METHODS says which (textbook_methods.h, CMakeLists.txt).
#include "tests/bench/kernels/textbook_tracer.h"

// Included after the kernels, so that they are found.
#include "tests/bench/kernels/kernel_sets.h"
#include "tracer/compile/geometry_build.h"
#include "tracer/intersect/searches_build.h"
#include "tracer/renderer_of.h"

namespace lancer {

template <>
[[gnu::visibility("default")]] std::unique_ptr<Renderer> compile_set<LANCER_METHODS>(
    const Scene& scene, const Settings& settings) {
    return std::make_unique<RendererOf<double>>(scene, settings);
}

}  // namespace lancer
