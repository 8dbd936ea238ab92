// The levels of rays side by side that the processor has.
#pragma once

#include <gtest/gtest.h>

#include "tests/oracle/wide_kernels.h"
#include "tracer/wide/level.h"

namespace lancer::oracle {

/// Calls test(kernels) for each level that the processor has.
template <class Test>
void on_each_level(Test&& test) {
    for (const Level level : {Level::avx2, Level::avx512}) {
        if (!is_supported(level)) continue;
        SCOPED_TRACE(name_of(level));
        test(level == Level::avx2 ? wide_kernels_avx2 : wide_kernels_avx512);
    }
}

}  // namespace lancer::oracle
