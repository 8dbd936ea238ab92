#include "tracer/recursion/recorded_tracer_build.h"

namespace lancer {

template class RecordedTracer<float>;
template class RecordedTracer<double>;
template class RecordedTracer<long double>;

}  // namespace lancer
