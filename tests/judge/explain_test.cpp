#include "judge/explain/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/judge/judge_worlds.h"

namespace lancer::judge {
namespace {

using testing::Contains;
using testing::HasSubstr;
using tiny::World;

TEST(Judge, PassesTheSameWorldRoundedTo16Bits) {
    const Judgement j = judge_worlds({}, {});
    EXPECT_TRUE(j.pass) << summary(j);
    EXPECT_EQ(j.count(PixelClass::agrees), j.pixels);
    EXPECT_LE(j.interior_max, 0.5 / 65535 * 1.0001);
    EXPECT_EQ(j.tight_share, 1);
}

TEST(Judge, FindsTheEdgesOfThePictureAndNotMore) {
    const Judgement j = judge_worlds({}, {});
    EXPECT_GT(j.edge_pixels, 1000u);
    EXPECT_LT(j.edge_pixels, j.pixels / 2);
}

/// Cells whose border runs exactly through a row of pixel centres, so that the last bit decides on
/// which side a centre lies.
World tied() {
    World world;
    world.balls.clear();
    world.cell = 40;
    const double y_of_row = 80.5;
    const double sy = 0.5 - y_of_row / world.height - 0.12;
    world.texture_offset = -(6.5 - 1.25 * 1.6 / -sy);
    return world;
}

TEST(Judge, ExplainsPixelsThatRoundingMovesAcrossAnEdge) {
    const World world = tied();
    Thresholds limits;
    limits.explained_share = 1;
    std::size_t explained = 0;
    for (const double shift : {-1e-11, 1e-11}) {
        World other = world;
        other.shift_y = shift;
        const Judgement j = judge_worlds(world, other, limits);
        EXPECT_TRUE(j.pass) << summary(j);
        EXPECT_EQ(j.count(PixelClass::texture), j.explained) << summary(j);
        EXPECT_EQ(j.displaced, 0u);
        explained += j.explained;
    }
    EXPECT_GT(explained, 50u) << "the border does not run through the row";
}

TEST(Judge, BoundsHowMuchEdgesMayExplain) {
    const World world = tied();
    World up = world;
    World down = world;
    up.shift_y = -1e-11;
    down.shift_y = 1e-11;
    const Judgement a = judge_worlds(world, up);
    const Judgement b = judge_worlds(world, down);
    const Judgement& j = a.explained > b.explained ? a : b;
    EXPECT_FALSE(j.pass);
    EXPECT_THAT(j.failures, Contains(HasSubstr("pixels are explained by edges, at most")));
}

TEST(Judge, NamesTheKindOfEdge) {
    // One pixel at a time takes the value from across the nearest edge of each kind.
    const World world;
    const tiny::Tracer tracer(world);
    const ProbeFunction probe = tiny::probe_of(world);
    std::size_t seen[pixel_classes] = {};
    for (int y = 0; y < world.height; ++y) {
        for (int x = 0; x + 1 < world.width; ++x) {
            // Bring the edge between the two pixels, if there is one, to the first one's centre.
            double low = x + 0.5;
            double high = x + 1.5;
            const Probe a = probe(low, y + 0.5);
            const Probe b = probe(high, y + 0.5);
            if (distance(a.color, b.color) < 0.2) continue;
            for (int i = 0; i < 45; ++i) {
                const double middle = 0.5 * (low + high);
                const Color c = probe(middle, y + 0.5).color;
                (distance(c, a.color) < distance(c, b.color) ? low : high) = middle;
            }
            const Probe before = probe(low, y + 0.5);
            const Probe after = probe(high, y + 0.5);
            if (distance(before.color, after.color) < 0.1) continue;
            // At its silhouette, glass has a value of its own in a band thinner than any pixel.
            if (distance(probe(high + 1e-9, y + 0.5).color, after.color) > 1e-3) continue;
            const auto edge = find_nearby_edge(probe, low, y + 0.5, after.color, 0.01, 1e-4);
            ASSERT_TRUE(edge) << x << " " << y;
            EXPECT_LT(std::hypot(edge->dx, edge->dy), 1e-8);
            if (before.object != after.object) {
                EXPECT_EQ(edge->kind, EdgeKind::silhouette);
                ++seen[static_cast<std::size_t>(PixelClass::silhouette)];
            } else if (before.lit != after.lit) {
                EXPECT_EQ(edge->kind, EdgeKind::shadow);
                ++seen[static_cast<std::size_t>(PixelClass::shadow)];
            } else if (before.path == after.path) {
                EXPECT_EQ(edge->kind, EdgeKind::texture);
                ++seen[static_cast<std::size_t>(PixelClass::texture)];
            } else {
                EXPECT_EQ(edge->kind, EdgeKind::secondary);
                ++seen[static_cast<std::size_t>(PixelClass::secondary)];
            }
        }
    }
    for (const PixelClass c :
         {PixelClass::silhouette, PixelClass::shadow, PixelClass::texture, PixelClass::secondary}) {
        EXPECT_GT(seen[static_cast<std::size_t>(c)], 5u) << class_name(c);
    }
}

TEST(FindCrossing, RefusesASmoothChangeHoweverSteep) {
    const ProbeFunction slope = [](double x, double) {
        Probe sample;
        sample.color = Color{1, 1, 1} * std::clamp(0.5 + 1e6 * (x - 0.5), 0.0, 1.0);
        return sample;
    };
    EXPECT_FALSE(find_nearby_edge(slope, 0.5, 0.5, {0.8, 0.8, 0.8}, 0.01, 1e-4));
}

TEST(FindCrossing, RefusesAnEdgeBehindWhichIsAnotherValue) {
    const ProbeFunction step = [](double x, double) {
        Probe sample;
        sample.color = x < 0.503 ? Color{0, 0, 0} : Color{1, 1, 1};
        return sample;
    };
    EXPECT_FALSE(find_nearby_edge(step, 0.5, 0.5, {0.9, 0.9, 0.9}, 0.01, 1e-4));
    EXPECT_TRUE(find_nearby_edge(step, 0.5, 0.5, {1, 1, 1}, 0.01, 1e-4));
}

TEST(FindCrossing, RefusesAnEdgeOutsideTheRadius) {
    const ProbeFunction step = [](double x, double) {
        Probe sample;
        sample.color = x < 0.512 ? Color{0, 0, 0} : Color{1, 1, 1};
        return sample;
    };
    EXPECT_FALSE(find_nearby_edge(step, 0.5, 0.5, {1, 1, 1}, 0.01, 1e-4));
}

TEST(FindCrossing, ReturnsTheOffsetOfTheEdge) {
    const ProbeFunction step = [](double x, double y) {
        Probe sample;
        sample.color = (x - 0.5) * 0.6 + (y - 0.5) * 0.8 < 0.004 ? Color{0, 0, 0} : Color{1, 1, 1};
        return sample;
    };
    const auto edge = find_nearby_edge(step, 0.5, 0.5, {1, 1, 1}, 0.01, 1e-4);
    ASSERT_TRUE(edge);
    EXPECT_NEAR(edge->dx * 0.6 + edge->dy * 0.8, 0.004, 1e-10);
    EXPECT_NEAR(std::hypot(edge->dx, edge->dy), 0.004, 1e-4) << "16 directions";
}

TEST(Judge, CountsAsKnownOnlyWhatTheOtherRuleGivesExactly) {
    const World world;
    World dimmer;
    dimmer.brightness = 0.9;  // the other program's rule
    World wrong;
    wrong.brightness = 0.899;
    const Image ours = tiny::Tracer(world).render();
    const ProbeFunction probe = tiny::probe_of(world);
    const ProbeFunction rule = tiny::probe_of(dimmer);
    const Judgement right =
        judge_pictures(ours, tiny::Tracer(dimmer).render(true), probe, {}, {rule, probe});
    EXPECT_EQ(right.count(PixelClass::unexplained), 0u) << summary(right);
    EXPECT_GT(right.count(PixelClass::known), 5000u);
    const Judgement off =
        judge_pictures(ours, tiny::Tracer(wrong).render(true), probe, {}, {rule, probe});
    EXPECT_GT(off.count(PixelClass::unexplained), 5000u) << summary(off);
}

TEST(Judge, DoesNotTakeOurOwnFaultForTheOthersRule) {
    const World right;
    World faulty;
    faulty.brightness = 1.01;
    const Image ours = tiny::Tracer(faulty).render();
    const Image theirs = tiny::Tracer(right).render(true);
    const ProbeFunction second = tiny::probe_of(right);
    const Judgement j = judge_pictures(ours, theirs, tiny::probe_of(faulty), {}, {second, second});
    EXPECT_FALSE(j.pass);
    EXPECT_LT(j.count(PixelClass::known), 10u) << "where the fault is hardly over `tight`";
    EXPECT_GT(j.count(PixelClass::unexplained), 5000u) << summary(j);
}

/// Our picture; their picture with one pixel brighter by 0.05; and their values around that pixel,
/// from the upper left, brighter by `brighter`.
Judgement judge_outlier(const std::array<double, 9>& brighter, int outliers = 1) {
    const World world;
    const Image ours = tiny::Tracer(world).render();
    Image theirs = tiny::Tracer(world).render(true);
    for (int i = 0; i < outliers; ++i)
        theirs.pixel(10 + i, 10)[1] = ours.pixel(10 + i, 10)[1] + 0.05;
    const auto around = [&](int x, int y, double) {
        Image image(3, 3);
        for (int i = 0; i < 9; ++i)
            for (int c = 0; c < 3; ++c)
                image.pixel(i % 3, i / 3)[c] =
                    ours.pixel(x, y)[c] + brighter[static_cast<std::size_t>(i)];
        return image;
    };
    return judge_pictures(ours, theirs, tiny::probe_of(world), {}, {{}, {}, around});
}

TEST(Judge, BelievesTheOtherPictureAroundAPixelMoreThanInIt) {
    const Judgement outlier = judge_outlier({0, 0, 0, 0, 0.05, 0, 0, 0, 0});
    EXPECT_TRUE(outlier.pass) << summary(outlier);
    EXPECT_EQ(outlier.count(PixelClass::outlier), 1u);
    EXPECT_TRUE(judge_outlier({-0.2, -0.2, -0.2, 0, 0.05, 0, 0.2, 0.2, 0.2}).pass) << "on a slope";
    EXPECT_TRUE(judge_outlier({0.05, 0, 0, 0, 0.05, 0, 0, 0, 0.05}).pass) << "on a streak";
    const double b = 0.05;
    EXPECT_FALSE(judge_outlier({b, b, b, b, b, b, b, b, b}).pass) << "it means it";
    EXPECT_FALSE(judge_outlier({b, b, b, 0, b, 0, b, b, b}).pass) << "one pair is not enough";
    EXPECT_FALSE(judge_outlier({0, 0, 0, 0, b, b, b, b, b}).pass) << "an edge of theirs";
    const double other = 0.02;
    EXPECT_FALSE(judge_outlier({other, other, other, other, b, other, other, other, other}).pass);
}

TEST(Judge, BelievesTheOtherPictureAroundAPixelOnAnEdge) {
    // Ours is bright from the centre on to the right; theirs has a third value on the edge.
    const World world;
    Image ours = tiny::Tracer(world).render();
    Image theirs = ours;
    const auto value = [](double x) { return x >= 10.5 ? 0.8 : 0.2; };
    const ProbeFunction probe = [&](double x, double y) {
        Probe sample = tiny::Tracer(world).probe(x, y);
        if (std::abs(x - 10.5) < 0.5 && std::abs(y - 10.5) < 0.5) sample.color = Color(value(x));
        return sample;
    };
    for (int c = 0; c < 3; ++c) {
        ours.pixel(10, 10)[c] = 0.8;
        theirs.pixel(10, 10)[c] = 0.5;
    }
    const auto judged = [&](double left) {
        const auto around = [&](int x, int, double pitch) {
            Image image(3, 3);
            for (int i = 0; i < 9; ++i)
                for (int c = 0; c < 3; ++c)
                    image.pixel(i % 3, i / 3)[c] = i == 4 ? 0.5
                                                   : i % 3 == 0
                                                       ? left
                                                       : value(x + 0.5 + (i % 3 - 1) * pitch);
            return image;
        };
        return judge_pictures(ours, theirs, probe, {}, {{}, {}, around});
    };
    const Judgement edge = judged(0.2);
    EXPECT_TRUE(edge.pass) << summary(edge);
    EXPECT_EQ(edge.count(PixelClass::outlier), 1u);
    EXPECT_FALSE(judged(0.3).pass) << "another value on one side";
}

TEST(Judge, AllowsFewOutliers) {
    const Judgement many = judge_outlier({0, 0, 0, 0, 0.05, 0, 0, 0, 0}, 20);
    EXPECT_FALSE(many.pass);
    EXPECT_EQ(many.count(PixelClass::outlier), many.pixels / 10000) << summary(many);
}

/// The picture of a world, except for one pixel where both programs see a slope of `slope` per
/// pixel.
Judgement judge_slope(double slope) {
    const World world;
    Image ours = tiny::Tracer(world).render();
    Image theirs = ours;
    const ProbeFunction probe = [&](double x, double y) {
        Probe sample = tiny::Tracer(world).probe(x, y);
        if (std::abs(x - 10.5) < 0.1 && std::abs(y - 10.5) < 0.1)
            sample.color = Color(std::clamp(0.4 + slope * (x - 10.5), 0.0, 1.0));
        return sample;
    };
    for (int c = 0; c < 3; ++c) {
        ours.pixel(10, 10)[c] = 0.4;
        theirs.pixel(10, 10)[c] = 0.4005;
    }
    return judge_pictures(ours, theirs, probe, {});
}

TEST(Judge, ExplainsASlopeOnlyWhenTheLastDigitsDecide) {
    const Judgement steep = judge_slope(1e4);  // 5e-8 pixel
    EXPECT_EQ(steep.count(PixelClass::steep), 1u) << summary(steep);
    EXPECT_TRUE(steep.pass) << summary(steep);
    const Judgement slope = judge_slope(1e3);  // 5e-7 pixel
    EXPECT_EQ(slope.count(PixelClass::unexplained), 1u) << summary(slope);
    EXPECT_FALSE(slope.pass);
}

TEST(Judge, ExplainsNothingWhereThePictureIsNotWhatTheRendererGives) {
    const World world;
    Image ours = tiny::Tracer(world).render();
    const Image theirs = tiny::Tracer(world).render(true);
    for (double& value : ours.data) value *= 0.9;
    const ProbeFunction probe = tiny::probe_of(world);
    const Judgement j = judge_pictures(ours, theirs, probe, {}, {probe, probe});
    EXPECT_EQ(j.explained, 0u) << summary(j);
    EXPECT_EQ(j.count(PixelClass::known), 0u) << summary(j);
    EXPECT_GT(j.count(PixelClass::unexplained), 5000u) << summary(j);
}

TEST(Judge, EndsWhenItsRaysAreUsedUpAndSaysSo) {
    World other;
    other.texture_offset += other.cell / 16;
    const Image ours = tiny::Tracer({}).render();
    const Image theirs = tiny::Tracer(other).render(true);
    std::uint64_t looks = 0;
    const ProbeFunction counting = [&](double x, double y) {
        ++looks;
        return tiny::Tracer({}).probe(x, y);
    };
    const Judgement all = judge_pictures(ours, theirs, counting, {});
    EXPECT_EQ(all.not_looked_at, 0u);
    const std::uint64_t looks_without_bound = looks;
    looks = 0;
    const std::uint64_t bound = all.rays / 4;
    const Judgement some = judge_pictures(ours, theirs, counting, {}, {}, bound);
    EXPECT_FALSE(some.pass);
    EXPECT_GT(some.not_looked_at, 0u);
    EXPECT_LT(some.not_looked_at, some.count(PixelClass::unexplained));
    EXPECT_GE(some.count(PixelClass::unexplained), all.count(PixelClass::unexplained));
    // The search for edges is the same; a pixel that was begun is finished.
    EXPECT_LT(some.rays, bound + 10000);
    EXPECT_EQ(looks_without_bound - looks, all.rays - some.rays);
    EXPECT_THAT(some.failures, Contains(HasSubstr("were not examined: explaining ended after")));
}

TEST(Judge, LooksFirstWhereFacesToldApartDoNotHelp) {
    const World world = tied();
    World other = world;
    other.shift_y = 1e-11;
    Thresholds limits;
    limits.explained_share = 1;
    const std::uint64_t of_edges = judge_worlds(world, other, limits).rays;
    const Image ours = tiny::Tracer(world).render();
    ResolvedPicture resolved;
    resolved.theirs = tiny::Tracer(other).render(true);
    resolved.by_rules = resolved.without = tiny::probe_of(world);
    Image theirs = resolved.theirs;
    for (int y = 10; y < 20; ++y)
        for (int x = 0; x < ours.width; ++x) theirs.pixel(x, y)[1] += 0.05;
    SecondLook second;
    second.resolved = [&]() -> const ResolvedPicture& { return resolved; };
    const Judgement j =
        judge_pictures(ours, theirs, tiny::probe_of(world), limits, second, of_edges + 100);
    EXPECT_TRUE(j.pass) << summary(j);
    EXPECT_EQ(j.count(PixelClass::coincident), static_cast<std::size_t>(10 * ours.width));
}

}  // namespace
}  // namespace lancer::judge
