// Traces the rays of a tile side by side, for processors with AVX2. The only file that is compiled
// with these instructions.
#define LANCER_LEVEL avx2
#include "tracer/wide/lanes_avx2.h"
// All of the level's code, in the order of use.
#include "tracer/wide/level_code.h"

namespace lancer::wide {

void trace_rays_avx2(Job& job, const Camera& camera, const double* x, const double* y, int count) {
    avx2::trace_rays(job, camera, x, y, count);
}

}  // namespace lancer::wide
