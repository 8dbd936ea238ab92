#include "tracer/wide/level.h"

#include <initializer_list>

namespace lancer {

const char* name_of(Level level) {
    switch (level) {
        case Level::avx2:
            return "avx2";
        case Level::avx512:
            return "avx512";
        case Level::scalar:
            break;
    }
    return "scalar";
}

bool is_supported(Level level) {
    if (level == Level::scalar) return true;
#ifdef __x86_64__
    // All instruction sets that CMakeLists.txt allows the compiler to use.
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
                      __builtin_cpu_supports("popcnt");
    if (level == Level::avx2) return avx2;
    return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
#else
    return false;
#endif
}

Level best_level() {
    for (const Level level : {Level::avx512, Level::avx2})
        if (is_supported(level)) return level;
    return Level::scalar;
}

}  // namespace lancer
