#include "tracer/render.h"

#include "tracer/render_types.h"

namespace lancer {

std::unique_ptr<Renderer> compile(const Scene& scene, const Settings& settings, Level level) {
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

}  // namespace lancer
