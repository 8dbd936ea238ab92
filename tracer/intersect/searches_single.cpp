#include "tracer/intersect/searches_build.h"

namespace lancer {

LANCER_SEARCHES(float);

}  // namespace lancer
