#include "tracer/compile/geometry_build.h"

namespace lancer {

template void compile_geometry(const Scene&, const Settings&, const Requirements&,
                               const PovRayRules*, Geometry<double>&);

}  // namespace lancer
