// The tiles that are rendered first represent the whole picture.
#include "tracer/tile_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lancer {
namespace {

TEST(TileOrder, VisitsEachTileOnce) {
    for (int count = 1; count <= 700; ++count) {
        const TileOrder order(count);
        std::vector<int> seen(static_cast<std::size_t>(count), 0);
        for (int i = 0; i < count; ++i) {
            ASSERT_GE(order[i], 0);
            ASSERT_LT(order[i], count);
            ++seen[static_cast<std::size_t>(order[i])];
        }
        for (int i = 0; i < count; ++i) ASSERT_EQ(seen[static_cast<std::size_t>(i)], 1) << count;
    }
}

TEST(TileOrder, LastTileOfTheLargestPicture) {
    const int count = 4096 * 4096;
    const TileOrder order(count);
    EXPECT_GE(order[count - 1], 0);
    EXPECT_LT(order[count - 1], count);
}

// A picture whose lower part takes a hundred times as long. A progress bar in the order of rows
// would show 1 % of the work at a third of the picture.
TEST(TileOrder, ShareOfTilesIsShareOfWork) {
    for (const int count : {300, 437, 1200, 4800, 9973}) {
        const TileOrder order(count);
        const auto work = [&](int tile) { return tile < count * 6 / 10 ? 1.0 : 100.0; };
        double total = 0;
        for (int i = 0; i < count; ++i) total += work(i);
        double done = 0;
        for (int i = 0; i < count; ++i) {
            done += work(order[i]);
            if (i < count / 20) continue;
            EXPECT_NEAR(done / total, (i + 1.0) / count, 0.25 * (i + 1.0) / count)
                << i << " of " << count;
        }
    }
}

}  // namespace
}  // namespace lancer
