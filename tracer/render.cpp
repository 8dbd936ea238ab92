#include "tracer/render.h"

#include "tracer/render_types.h"

namespace lancer {

namespace {

/// \param level  used only in double precision
std::unique_ptr<RayTreeRenderer> compile_by_precision(const Scene& scene, const Settings& settings,
                                                      Level level) {
    switch (settings.precision) {
        case Precision::single:
            return compile_single(scene, settings);
        case Precision::extended:
            return compile_extended(scene, settings);
        case Precision::double_:
            break;
    }
    return compile_double(scene, settings, level);
}

}  // namespace

std::unique_ptr<Renderer> compile(const Scene& scene, const Settings& settings, Level level) {
    return compile_by_precision(scene, settings, level);
}

std::unique_ptr<RayTreeRenderer> compile_for_ray_trees(const Scene& scene,
                                                       const Settings& settings) {
    return compile_by_precision(scene, settings, Level::scalar);
}

}  // namespace lancer
