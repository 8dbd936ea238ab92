// Pictures compared with those in 113 bits, at half the size because these are slow;
// docs/accuracy.md has full sizes. Also decisions that depend on the last digit.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/extremes/picture.h"
#include "tests/extremes/rows.h"
#include "tests/quad/quad.h"
#include "tracer/shading/optics.h"

namespace lancer::extremes {
namespace {

class LastDigits : public testing::TestWithParam<Row> {};

TEST_P(LastDigits, OfARow) {
    const Row& row = GetParam();
    std::optional<Image> truth;
    for (const int k : row.ks) {
        const std::optional<int> allowed = row.allowed(k);
        if (!allowed) continue;
        if (!truth || !row.steady) truth = quad_picture(half_size(row.exactly_as(k)));
        EXPECT_LE(wrong(picture(half_size(row.scene(k))), *truth), *allowed)
            << row.name << ", k = " << k;
    }
    EXPECT_TRUE(truth);
}

std::vector<Row> judged_rows() {
    std::vector<Row> rows = all_rows();
    std::erase_if(rows, [](const Row& row) { return !row.exactly_as; });
    return rows;
}
INSTANTIATE_TEST_SUITE_P(Rows, LastDigits, testing::ValuesIn(judged_rows()));

/// 10^-15 to 10^-1 from the critical angle of random indices.
TEST(LastDigits, OfTheCriticalAngle) {
    std::mt19937 random(1);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    int reflected = 0;
    constexpr int rays = 20000;
    for (int i = 0; i < rays; ++i) {
        const double ratio = 1 + std::pow(10.0, -4 * unit());
        const double off = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, -1 - 14 * unit());
        const Quad angle = elementary::asin(1 / Quad(ratio)) + off;
        const Vec3d in(static_cast<double>(elementary::sin(angle)),
                       static_cast<double>(-elementary::cos(angle)), 0);
        const Vec3<Quad> in_quad = convert<Quad>(in);
        Vec3d out;
        Vec3<Quad> truth;
        const bool through = refracted(in, Vec3d(0, 1, 0), ratio, out);
        ASSERT_EQ(through, refracted(in_quad, Vec3<Quad>(0, 1, 0), Quad(ratio), truth)) << i;
        reflected += !through;
    }
    EXPECT_GT(reflected, rays / 3);
    EXPECT_LT(reflected, 2 * rays / 3);
}

}  // namespace
}  // namespace lancer::extremes
