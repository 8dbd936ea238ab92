#define LANCER_LEVEL avx512
#include "tracer/wide/lanes_avx512.h"
//
#include "tracer/wide/level_code.h"
//
#include "tests/bench/search/level_search.h"

namespace lancer::wide {

void search_eight_avx512(const Job& job, EightRays& rays) {
    avx512::search_eight(job, rays);
}

}  // namespace lancer::wide
