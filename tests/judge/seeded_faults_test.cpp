// Errors that a ray tracer typically has, put into one of two pictures: none is explained away.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/judge/judge_worlds.h"

namespace lancer::judge {
namespace {

using testing::Contains;
using testing::HasSubstr;
using tiny::World;

TEST(SeededFault, ALampOnePercentDimmerIsUnexplained) {
    World other;
    other.brightness = 0.99;
    const Judgement j = judge_worlds({}, other);
    EXPECT_FALSE(j.pass);
    EXPECT_GT(j.count(PixelClass::unexplained), j.pixels / 4) << summary(j);
    EXPECT_EQ(j.explained, 0u) << summary(j);
}

TEST(SeededFault, AFlippedNormalIsUnexplained) {
    World other;
    other.balls[0].inside_out = true;
    const Judgement j = judge_worlds({}, other);
    EXPECT_FALSE(j.pass);
    EXPECT_GT(j.count(PixelClass::unexplained), 500u) << summary(j);
}

TEST(SeededFault, AnIorOffByAHundredthIsUnexplained) {
    World other;
    other.balls[2].ior = 1.51;
    const Judgement j = judge_worlds({}, other);
    EXPECT_FALSE(j.pass);
    EXPECT_GT(j.count(PixelClass::unexplained), 20u) << summary(j);
}

TEST(SeededFault, ATextureShiftedByATexelIsUnexplained) {
    World other;
    other.texture_offset += other.cell / 16;
    const Judgement j = judge_worlds({}, other);
    EXPECT_FALSE(j.pass);
    EXPECT_GT(j.count(PixelClass::unexplained), 50u) << summary(j);
}

TEST(SeededFault, AMissingSphereIsUnexplained) {
    World other;
    other.balls.pop_back();
    const Judgement j = judge_worlds({}, other);
    EXPECT_FALSE(j.pass);
    EXPECT_GT(j.count(PixelClass::unexplained), 300u) << summary(j);
}

TEST(SeededFault, AWrongGammaIsUnexplained) {
    World other;
    other.gamma = 1 / 2.2;
    const Judgement j = judge_worlds({}, other);
    EXPECT_FALSE(j.pass);
    EXPECT_GT(j.count(PixelClass::unexplained), j.pixels / 4) << summary(j);
}

TEST(SeededFault, ACameraOffByHundredthsOfAPixelIsAShift) {
    for (const double shift : {0.005, -0.005, 0.02}) {
        World right;
        right.shift_x = shift;
        World down;
        down.shift_y = shift;
        const Judgement across = judge_worlds({}, right);
        const Judgement along = judge_worlds({}, down);
        EXPECT_FALSE(across.pass) << summary(across);
        EXPECT_FALSE(along.pass) << summary(along);
        EXPECT_THAT(across.failures, Contains(HasSubstr("the other picture is shifted")));
        EXPECT_THAT(along.failures, Contains(HasSubstr("the other picture is shifted")));
        // A camera that moves to the right shows everything further to the left.
        EXPECT_NEAR(across.picture_shift.x, -shift, 0.25 * std::abs(shift)) << summary(across);
        EXPECT_NEAR(along.picture_shift.y, -shift, 0.25 * std::abs(shift)) << summary(along);
    }
}

TEST(SeededFault, ACameraOffInAFlatWorldShowsInItsEdges) {
    // Without shading there is no gradient: only the edges can reveal it.
    World world;
    world.width = 640;
    world.height = 480;
    world.brightness = 0;
    world.balls[1].mirror = 0;
    world.balls.pop_back();
    World other = world;
    other.shift_x = 0.005;
    const Judgement j = judge_worlds(world, other);
    EXPECT_FALSE(j.pass) << summary(j);
    EXPECT_GT(j.displaced, 1u) << summary(j);
}

// ---- The statistics

TEST(Registration, FindsAShiftInNoise) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
    Image ours(60, 50);
    Image theirs(60, 50);
    const auto surface = [](double x, double y, int c) {
        return 0.5 + 0.3 * std::sin(0.2 * x + c) * std::cos(0.17 * y);
    };
    for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 60; ++x) {
            for (int c = 0; c < 3; ++c) {
                ours.pixel(x, y)[c] = surface(x, y, c);
                theirs.pixel(x, y)[c] = surface(x - 0.01, y + 0.02, c) + noise(random);
            }
        }
    }
    const Shift shift = register_pictures(ours, theirs, Mask(60 * 50));
    EXPECT_NEAR(shift.x, 0.01, 3 * shift.error_x + 2e-4);
    EXPECT_NEAR(shift.y, -0.02, 3 * shift.error_y + 2e-4);
    EXPECT_TRUE(shift.is_significant(1e-3, 5));
    EXPECT_LT(shift.error_x, 1e-4);
}

TEST(Registration, HasNothingToSayOfAFlatPicture) {
    const Image flat(20, 20);
    const Shift shift = register_pictures(flat, flat, Mask(400));
    EXPECT_EQ(shift.count, 0u);
    EXPECT_FALSE(shift.is_significant(1e-3, 5));
}

TEST(MeanOffset, IsSignificantWhenAllLieOnOneSide) {
    const std::vector<Offset> aside{{2e-3, 0},   {3e-3, 1e-4},   {1e-3, -1e-4}, {2e-3, 1e-4},
                                    {2.5e-3, 0}, {1.5e-3, 1e-4}, {2e-3, -1e-4}};
    EXPECT_TRUE(mean_offset(aside).is_significant(1e-4, 3));
    EXPECT_FALSE(mean_offset({{2e-3, 0}, {3e-3, 1e-4}, {1e-3, -1e-4}}).is_significant(1e-4, 3))
        << "three may lie on one side by chance";
    EXPECT_FALSE(mean_offset({{1.2e-3, 0}, {1e-3, 1e-4}}).is_significant(1e-4, 3));
    EXPECT_FALSE(mean_offset({{2e-3, 0}, {-3e-3, 0}, {1e-3, 0}}).is_significant(1e-4, 3));
    EXPECT_FALSE(mean_offset({{2e-12, 0}, {3e-12, 0}, {2.5e-12, 0}}).is_significant(1e-4, 3));
}

}  // namespace
}  // namespace lancer::judge
