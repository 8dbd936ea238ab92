// The kernels of one level, compiled with its instructions.
#define LANCER_LEVEL avx512
#include "tests/oracle/wide_kernels.h"
#include "tracer/wide/lanes_avx512.h"
//
#include "tracer/wide/level_code.h"
//
#include "tests/oracle/wide_kernels_code.h"

namespace lancer::oracle {

const WideKernels wide_kernels_avx512 = wide::avx512::kernels;

}  // namespace lancer::oracle
