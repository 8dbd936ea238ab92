#include "tracer/render.h"

#include "tracer/render_types.h"

namespace lancer {

RayCounts& RayCounts::operator+=(const RayCounts& more) {
    primary += more.primary;
    shadow += more.shadow;
    reflected += more.reflected;
    transmitted += more.transmitted;
    media_lost += more.media_lost;
    return *this;
}

std::unique_ptr<Renderer> compile(const Scene& scene, const Settings& settings) {
    switch (settings.precision) {
        case Precision::single:
            return compile_single(scene, settings);
        case Precision::extended:
            return compile_extended(scene, settings);
        case Precision::double_:
            break;
    }
    return compile_double(scene, settings);
}

}  // namespace lancer
