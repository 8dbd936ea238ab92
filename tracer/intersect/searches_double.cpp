#include "tracer/intersect/searches_build.h"

namespace lancer {

LANCER_SEARCHES(double);

}  // namespace lancer
