#define LANCER_LEVEL avx2
#include "tracer/wide/lanes_avx2.h"
//
#include "tracer/wide/level_code.h"
//
#include "tests/bench/search/level_search.h"

namespace lancer::wide {

void search_eight_avx2(const Job& job, EightRays& rays) {
    avx2::search_eight(job, rays);
}

}  // namespace lancer::wide
