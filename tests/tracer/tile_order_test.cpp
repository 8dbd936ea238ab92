// The tiles that are rendered first represent the whole picture, and neighbours follow each other.
#include "tracer/tile_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace lancer {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1},   {1, 700}, {700, 1}, {20, 15},  {23, 19},
                                         {40, 30}, {64, 64}, {80, 60}, {97, 103}, {256, 128}};

std::vector<TilePlace> tiles_of(int across, int down) {
    const TileOrder order(across, down);
    std::vector<TilePlace> tiles;
    for (int i = 0; i < order.count(); ++i)
        if (const auto place = order[i]) tiles.push_back(*place);
    return tiles;
}

TEST(TileOrder, VisitsEachTileOnce) {
    const auto check = [](int across, int down) {
        std::vector<int> seen(static_cast<std::size_t>(across * down), 0);
        for (const auto& [column, row] : tiles_of(across, down)) {
            ASSERT_TRUE(column >= 0 && column < across && row >= 0 && row < down);
            ++seen[static_cast<std::size_t>(row * across + column)];
        }
        for (const int times : seen) ASSERT_EQ(times, 1) << across << " x " << down;
    };
    for (int count = 1; count <= 700; ++count) check(count, 1);
    for (const auto& [across, down] : sizes) check(across, down);
}

TEST(TileOrder, LastTileOfTheLargestPicture) {
    const TileOrder order(4096, 4096);
    const auto place = order[order.count() - 1];
    ASSERT_TRUE(place);
    EXPECT_TRUE(place->column >= 0 && place->column < 4096 && place->row >= 0 && place->row < 4096);
}

// A picture whose lower part takes a hundred times as long. A progress bar in the order of rows
// would show 1 % of the work at a third of the picture.
TEST(TileOrder, ShareOfTilesIsShareOfWork) {
    for (const auto& [across, down] : sizes) {
        const std::vector<TilePlace> tiles = tiles_of(across, down);
        if (tiles.size() < 300 || down == 1 || across == 1) continue;
        const auto work = [down = down](const TilePlace& tile) {
            return tile.row < down * 6 / 10 ? 1.0 : 100.0;
        };
        double total = 0;
        for (const TilePlace& tile : tiles) total += work(tile);
        const auto count = static_cast<double>(tiles.size());
        double done = 0;
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            done += work(tiles[i]);
            const double share = (static_cast<double>(i) + 1) / count;
            if (share < 0.05) continue;
            EXPECT_NEAR(done / total, share, 0.25 * share)
                << i << " of " << across << " x " << down;
        }
    }
}

TEST(TileOrder, NeighboursFollowEachOther) {
    const std::vector<TilePlace> tiles = tiles_of(256, 128);
    int near = 0;
    for (std::size_t i = 1; i < tiles.size(); ++i)
        near += std::abs(tiles[i].column - tiles[i - 1].column) <= 4 &&
                std::abs(tiles[i].row - tiles[i - 1].row) <= 4;
    EXPECT_GT(near, static_cast<int>(tiles.size()) * 9 / 10);
}

}  // namespace
}  // namespace lancer
