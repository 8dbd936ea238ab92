// Every row of docs/accuracy.md must meet its aims; `extended` replaces 113 bits, which would be
// too slow here.
#include "tests/extremes/rows.h"

#include <gtest/gtest.h>

#include "model/diagnostic.h"
#include "tests/extremes/picture.h"

namespace lancer::extremes {
namespace {

class Rows : public testing::TestWithParam<Row> {};

int wrong_at(const Row& row, int k) {
    const Image image = picture(row.scene(k));
    if (row.uniform) return wrong(image, *row.uniform);
    if (row.formula) return wrong(image, row.formula(k));
    if (row.exactly_as) return wrong(image, picture(row.exactly_as(k), Precision::extended));
    const Image same = picture(row.same_as(k));
    return row.bits ? different(image, same) : wrong(image, same);
}

TEST_P(Rows, HoldTheirAims) {
    const Row& row = GetParam();
    int asked = 0;
    for (const int k : row.ks) {
        const std::optional<int> allowed = row.allowed(k);
        if (!allowed) continue;
        ++asked;
        EXPECT_LE(wrong_at(row, k), *allowed) << row.name << ", k = " << k;
    }
    EXPECT_GT(asked, 0);
}

/// Right within the limits of the type, or refused: picture() checks that every value is finite.
TEST_P(Rows, AreDrawnInSinglePrecision) {
    const Row& row = GetParam();
    for (const int k : row.ks) {
        SCOPED_TRACE(row.name + ", k = " + std::to_string(k));
        try {
            picture(row.scene(k), Precision::single);
        } catch (const SceneError& error) {
            EXPECT_STRNE(error.what(), "");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Places, Rows, testing::ValuesIn(rows_of_places()));
INSTANTIATE_TEST_SUITE_P(Gaps, Rows, testing::ValuesIn(rows_of_gaps()));
INSTANTIATE_TEST_SUITE_P(Shapes, Rows, testing::ValuesIn(rows_of_shapes()));
INSTANTIATE_TEST_SUITE_P(Bodies, Rows, testing::ValuesIn(rows_of_bodies()));
INSTANTIATE_TEST_SUITE_P(Light, Rows, testing::ValuesIn(rows_of_light()));

}  // namespace
}  // namespace lancer::extremes
