#include "tracer/recursion/cut_tracer_build.h"

namespace lancer {

template class CutTracer<float>;
template class CutTracer<double>;
template class CutTracer<long double>;

}  // namespace lancer
